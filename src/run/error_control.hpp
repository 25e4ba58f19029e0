#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "measure/impact_answer.hpp"
#include "run/compose.hpp"
#include "run/finished_impact.hpp"
#include "run/impact_estimate.hpp"
#include "run/run.hpp"

namespace impact {

/// Keeps the error of a scene's answer, its restitution or strain, within numerics.error: examines
/// each finished run, and asks for another one with a finer resolution until the error is small
/// enough.
///
/// Collision: runs each with shorter steps than the one before, as planned by first_resolution()
/// and then by a factor of 1.2 at least, until what they say together is good, see ImpactEstimate.
///
/// If what `reduced` or `modal` leaves out exceeds kMostLeftOut of numerics.error, or the lattice
/// comes near a fold, which these do not see, `auto` goes on with all points.
///
/// A start that turns out too near to the wall, since little speed is left after the impact, is
/// raised; so is that of a lattice that folds, which may make much of what it missed of the wall.
///
/// Where `auto` began with `modal` or `imex` and its runs fail, need too many steps or do not
/// agree, it goes on with the other methods.
///
/// A run whose step was reduced on the way does not count, but tells how stiff the wall becomes, by
/// which the next ones are planned. If runs of a method of order 2 show that
/// it needs more steps than expected, `auto` may go over to one of order 6.
///
/// Contact: the strain of the state at rest against that after one more step of Newton's method,
/// which converges quadratically, and the rounding of positions, 4 ε R.
///
/// Where the scene gives a step or tolerance, its first run of a collision is taken as it is, and
/// its error is not known.
class ErrorControl {
 public:
  ErrorControl(Scene scene, const Composition& composition);

  /// How the next run is to be made.
  const Resolution& resolution() const { return resolution_; }

  /// How the runs after the next one will have to be made, as far as they are sure to be needed.
  std::vector<Resolution> later_resolutions() const;

  /// Whether the answer is good.
  bool accepted() const { return accepted_; }

  /// Takes in a finished run made so, and what was measured of it. True when the answer is good.
  /// @throw RunFailure when the answer cannot be had, with the cause.
  bool accepts(const Run& run, const Restitution& measured);
  /// The same for a collision.
  bool accepts(const FinishedImpact& run);

  /// Takes in that a run broke off, to go on with a finer one.
  /// @throw RunFailure, the given one, when finer runs would not help or are not wanted.
  void take_failure(const RunFailure& failure);

  /// Makes all runs of a collision, unseen, until the answer is good or `stop`, asked every 64
  /// steps, says true. A run at resolution() is then the last of them once more. Does nothing for
  /// scenes of which the first run is the answer.
  /// @throw RunFailure as accepts().
  void find_resolution(const std::shared_ptr<const Composition>& composition,
                       const std::function<bool()>& stop);

  /// Of a collision, once accepted; before, NaN.
  const ImpactAnswer& answer() const { return estimate_.answer(); }

  /// Relative, of e or ξ, or that of β or of the spin where it is greater; NaN: not known.
  double estimated_error() const { return estimated_error_; }

 private:
  bool is_controlled() const;
  void plan(const Resolution& finest);
  void plan_after_halving(const FinishedImpact& run);
  void go_on(double factor);
  void refine(double factor);
  bool go_over(double step);
  void shorten(double factor);
  bool accepts_contact(const Run& run);
  bool starts_too_near(const FinishedImpact& run);
  const ModelError& model_error_of(const Run& run);
  bool leaves_out_too_much(const FinishedImpact& run);
  bool go_on_otherwise();
  void refine_by_estimate();
  [[noreturn]] void give_up(const std::string& cause) const;

  Scene scene_;
  Rates rates_;
  double expected_time_;
  Resolution resolution_;
  Eigen::Index points_;  ///< of the disk
  double most_steps_ = 0.0;
  std::vector<Resolution> planned_;  ///< after the present one, the next one last
  ImpactEstimate estimate_;
  ModelError model_error_;  ///< of the method of its runs
  double estimated_error_ = std::numeric_limits<double>::quiet_NaN();
  double last_estimate_ = std::numeric_limits<double>::infinity();
  /// Refinements in turn that left the estimate as it was: as long as coarser runs are compared
  /// with, that may be due to them.
  int stagnations_ = 0;
  int failures_ = 0;  ///< runs that broke off
  int halvings_ = 0;  ///< runs whose step was reduced
  bool accepted_ = false;
  bool is_lifted_for_folds_ = false;
};

}  // namespace impact
