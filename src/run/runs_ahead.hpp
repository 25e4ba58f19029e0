#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "kernels/threads.hpp"
#include "run/compose.hpp"
#include "run/run.hpp"

namespace impact {

/// Runs of an answer that are made on other processors while the first of them is under way. The
/// results are the same to the last bit, only the answer is there sooner.
class RunsAhead {
 public:
  RunsAhead(Scene scene, std::shared_ptr<const Composition> composition)
      : scene_(std::move(scene)), composition_(std::move(composition)) {}
  RunsAhead(const RunsAhead&) = delete;
  RunsAhead& operator=(const RunsAhead&) = delete;
  /// Gives up what nobody has asked for.
  ~RunsAhead();

  /// `present`: the run that will be asked for next, and `later` those after it, in their order.
  /// Begins the last of these, which are the longest, as far as there are processors for them, and
  /// gives up what was begun and is neither. None where a run is large enough to take all
  /// processors by itself, or threads_in_a_run() is 1.
  void begin(const Resolution& present, const std::vector<Resolution>& later);

  /// Waits for the end of the run if it was begun ahead. Gives it up when `stop`, asked meanwhile,
  /// says true.
  void wait_for(const Resolution& resolution, const std::function<bool()>& stop);

  /// The run, after wait_for(): at its end if it was begun ahead, else at its beginning. So it is
  /// too if it failed, to fail where it is looked at, and if it was given up.
  Run take(const Resolution& resolution, const std::function<bool()>& stop);

 private:
  struct Ahead {
    Resolution resolution;
    std::shared_ptr<std::atomic<bool>> given_up;
    std::future<std::optional<Run>> run;  ///< nothing: failed or given up
    JoinedThread thread;
  };

  void give_up_all_but(const Resolution& present, const std::vector<Resolution>& later);
  void begin_one(const Resolution& resolution);
  std::optional<Run> make(const Resolution& resolution, const std::atomic<bool>& given_up) const;
  std::vector<Ahead>::iterator find(const Resolution& resolution);

  Scene scene_;
  std::shared_ptr<const Composition> composition_;
  std::vector<Ahead> ahead_;
};

}  // namespace impact
