#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "measure/elastic_constants.hpp"
#include "measure/impact_answer.hpp"
#include "measure/strain.hpp"
#include "output/result.hpp"
#include "run/error_control.hpp"
#include "run/run.hpp"
#include "run/runs_ahead.hpp"
#include "series/history.hpp"

namespace impact {

/// Simulates and measures one scene, in as many runs as its error control asks for.
class ConvergenceStudy {
 public:
  /// `history`: takes in the states at the output times; outlives the study. Without it, runs that
  /// are sure to be needed are made at the same time, see RunsAhead.
  /// @throw InputError as compose().
  explicit ConvergenceStudy(const Scene& scene, History* history = nullptr)
      : ConvergenceStudy(scene, compose_shared(scene), history) {}
  /// `composition`: of the scene.
  ConvergenceStudy(const Scene& scene, const std::shared_ptr<const Composition>& composition,
                   History* history = nullptr);

  using MakeRun = std::function<Run(const Resolution&)>;
  /// Of runs that are moved from outside: then observe_step() or observe_solution() is called, not
  /// advance(). They may have gone on before they are asked for.
  ConvergenceStudy(const Scene& scene, std::shared_ptr<const Composition> composition,
                   MakeRun make_run)
      : ConvergenceStudy(scene, std::move(composition), std::move(make_run), nullptr) {}

  /// Goes on as Run::advance() and takes in what the measurements need; at the end of a run that is
  /// not accurate enough, starts the next one.
  /// @throw RunFailure as Run::advance() and ErrorControl::accepts().
  void advance(const std::function<bool()>& stop = {});
  /// To be called after each step of a run that is moved from outside. At the end of one that is
  /// not accurate enough, asks for the next one.
  /// @throw RunFailure as advance().
  void observe_step();
  /// To be called when the search for a static solution, which is done outside, has finished.
  /// @throw RunFailure as advance().
  void observe_solution(const EquilibriumSearch& search);
  bool finished() const { return finished_; }
  /// See ErrorControl.
  std::vector<Resolution> later_resolutions() const { return control_.later_resolutions(); }

  /// The values of quantities(), in their order.
  Result result() const;

  const Scene& scene() const { return scene_; }
  /// The present run, at the end the finest one.
  const Run& run() const { return *run_; }
  /// So many runs were begun, the present one included.
  int runs() const { return runs_; }
  double estimated_error() const { return control_.estimated_error(); }
  /// Of a collision, at the end.
  const ImpactAnswer& impact() const { return control_.answer(); }
  /// Of the present run.
  Restitution restitution_of_run() const;
  Strain strain() const;
  /// What numerics.error is about: ξ of a contact, e of a collision.
  double answer() const;
  /// E and ν of a stretched rectangle, in the middle of it: half its width and half its height.
  /// @throw RunFailure when too few points lie there.
  ElasticConstants elastic_constants() const;
  /// The pull on the grips over the rectangle's height and strain, in M c²/R²: E of the rectangle
  /// as a whole, with its rim.
  double grip_modulus() const;
  double wall_time() const;  ///< s, since construction, or as given

  /// Replaces the time since construction by this one (s).
  void set_wall_time(double time) { given_wall_time_ = time; }

 private:
  ConvergenceStudy(const Scene& scene, std::shared_ptr<const Composition> composition,
                   MakeRun make_run, History* history);

  void make_way();
  Run next_run();
  void start_run();
  /// Takes in what `move` does to the run.
  template <class Move>
  void go_on(const Move& move);
  void end_run();
  void take_in();
  BondLaw law() const;

  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  Scene scene_;
  std::shared_ptr<const Composition> composition_;
  MakeRun make_run_;                  ///< empty: runs are made here
  std::unique_ptr<RunsAhead> ahead_;  ///< nullptr: each run is made when it is asked for
  std::function<bool()> stop_{};      ///< of advance()
  ErrorControl control_;
  std::optional<Run> run_;
  int runs_ = 0;
  ImpactAnalysis analysis_;
  History* history_;  ///< nullptr: nobody wants it
  std::optional<double> given_wall_time_;
  bool finished_ = false;
};

/// One entry of a result.
struct Quantity {
  std::string key;
  std::function<Result::Value(const ConvergenceStudy&)> value;
};

/// Everything that the result of such a scene holds, in the order in which it is shown.
std::vector<Quantity> quantities(const Scene& scene);

}  // namespace impact
