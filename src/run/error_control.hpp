#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "run/compose.hpp"
#include "run/run.hpp"

namespace impact {

/// Sees to it that the answer of a scene, its restitution or strain, errs by no more than
/// numerics.error: looks at each run when it is done, and asks for another one, more finely
/// resolved, until the estimated error is small enough.
///
/// Collision: step doubling in the wider sense. The answer is the velocity v′ of the centre of mass
/// after the impact; two runs with steps h and r h, r ≥ 1.3, and a method of order p give the
/// estimate 2 |v′(h) − v′(rh)|/((r^p − 1) |v′(h)|), with a margin of 2. Where damping is stiff
/// (γ h > 1) the extrapolated method counts with p = 3. For an adaptive integrator
/// the two tolerances differ by 1.3⁴ at least and the difference itself is the estimate. ε/100 is
/// added for the wall's tail, in which the motion begins and ends. A run whose step was reduced on
/// the way counts with its shortest step, and only serves as the coarser of two. Where the lattice
/// folds, which amplifies errors, or the step that should have been short enough was not, two
/// estimates in a row must be good. Where two runs of a method of order 2 show that it needs more
/// steps than expected, `auto` may go over to one of order 6.
///
/// Contact: the strain of the state at rest against that after one more step of Newton's method,
/// which converges quadratically.
///
/// Where the scene gives a step or tolerance, its first run of a collision is taken as it is, and
/// its error is not known.
class ErrorControl {
 public:
  ErrorControl(Scene scene, const Composition& composition);

  /// How the next run is to be made.
  const Resolution& resolution() const { return resolution_; }

  /// How the run after the first will have to be made, as far as can be foreseen: empty when none
  /// is sure to be needed.
  std::optional<Resolution> second_resolution() const;

  /// Takes in a finished run made so. True when its answer is good.
  /// @throw RunFailure when the answer cannot be had, with the cause.
  bool accepts(const Run& run);

  /// Takes in that a run broke off, to go on with a finer one.
  /// @throw RunFailure, the given one, when finer runs would not help or are not wanted.
  void take_failure(const RunFailure& failure);

  /// Makes all runs of a collision, unseen, until one is accepted or `stop`, asked every 64 steps,
  /// says true. A run at resolution() is then good.
  /// @throw RunFailure as accepts().
  void find_resolution(const std::shared_ptr<const Composition>& composition,
                       const std::function<bool()>& stop);

  /// Relative; NaN: not known.
  double estimated_error() const { return estimated_error_; }

 private:
  struct Answer {
    Resolution resolution;
    Eigen::Array2d velocity;
  };

  bool accepts_impact(const Run& run);
  bool accepts_contact(const Run& run);
  void refine(double wanted_factor);
  [[noreturn]] void give_up(const std::string& cause) const;

  Scene scene_;
  Rates rates_;
  double expected_time_;
  Resolution resolution_;
  double most_steps_;
  std::optional<Answer> last_;
  double estimated_error_ = std::numeric_limits<double>::quiet_NaN();
  double last_estimate_ = std::numeric_limits<double>::infinity();
  int stagnations_ = 0;
  bool unruly_ = false;  ///< the lattice folds, or an error did not fall as the order promises
  bool last_was_good_ = false;
};

}  // namespace impact
