#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "measure/impact_answer.hpp"
#include "run/compose.hpp"
#include "run/convergence.hpp"
#include "run/run.hpp"

namespace impact {

/// What error control needs to know of an impact that was run to its end.
struct FinishedImpact {
  Restitution measured;
  double step = 0.0;  ///< R/c, at the end: the shortest
  std::uint64_t steps = 0;
  double time = 0.0;        ///< R/c
  double tail_error = 0.0;  ///< Run::tail_error()
  /// Relative: how far it could change e that contacts pass from bond to bond, by hops of energy
  /// and by turns of the force.
  double error_by_hops = 0.0;
  ModelError model_error{};  ///< of the bodies that were moved
  bool step_reduced = false;
  double stiffest_contact = 0.0;  ///< System::stiffest_contact()
  double lost_of_spin = 0.0;      ///< by damping, relative, from the end of the contact on
  bool not_separated = false;
  bool folded = false;
  bool cut_off = false;
};

/// Keeps the error of a scene's answer, its restitution or strain, within numerics.error: examines
/// each finished run, and asks for another one with a finer resolution until the error is small
/// enough.
///
/// Collision: at least three runs, each with shorter steps than the one before, as planned by
/// first_resolution() and then by a factor of 1.2 at least; two where the second has half the steps
/// and differs by no more than a fiftieth of numerics.error, which then is the error. The answer, e
/// and all other numbers of the impact, is what converged() gives for the last ones: extrapolated
/// to zero step if they show the order of the method, else that of the finest run. A limit of three
/// runs is accepted up to a tenth of numerics.error, but for what a model leaves out; above that a
/// fourth run has to confirm it, unless four were planned, and then it is accepted up to half of
/// numerics.error. If 1/500 of what was extrapolated exceeds numerics.error, limits are asked to
/// agree twice; those of three are also if the term after the two that they are fitted to may do
/// so, as the stiffness of the wall says, or, where the wall is hard over the spacing of the
/// points, all that was extrapolated. An order is not looked for
/// - where a point of the disk comes further towards the wall than half its range 1/a in a step,
/// - where contacts pass from bond to bond, and what that does to their energy and to the direction
///   of their force could change e by numerics.error,
/// - where the lattice folds, or the wall is cut off at wall.threshold: these scatter most, so five
///   runs are compared, see compared_if_all_fall(),
/// - by `takahashi_imada`, where forces act at the start, see Scene::flies_without_forces(),
/// - for an adaptive integrator, the tolerance of which stands for the square of a step,
/// - for numbers that are read off the steps, see is_read_off_steps().
///
/// An impact that is oblique or spins is good when e is, the tangential restitution β to within
/// numerics.error, and the spin to within that part of the disk's speed and its spin at the start.
///
/// What the wall still holds at the end of a run is counted as velocity. Three things are added to
/// the error:
/// - what the wall does before the start and after the end of a run, Run::tail_error(),
/// - what passing from bond to bond leaves open, since a step notices it late: its possible effect
///   on e, times a v h,
/// - rounding, 16 ε √steps (ε: spacing of doubles): two to ten times the scatter of e with other
///   wall.V0, v = 10⁻⁶ … 10⁻² c; where steps solve for damped velocities, 16 ε steps, since their
///   rounding goes to one side: 4.5 ε a step was seen.
/// Where the method is `reduced` or `modal`, what it leaves out is added too, see left_out() and
/// ModalCorrection. If that exceeds kMostLeftOut of numerics.error, or the lattice comes near a
/// fold, which these do not see, `auto` goes on with all points.
/// Spins are those at the end of the run. What damping takes of them in flight, from the end of the
/// contact on, counts as an error of theirs and of what depends on them.
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
  const ImpactAnswer& answer() const { return answer_; }

  /// Relative, of e or ξ, or that of β or of the spin where it is greater; NaN: not known.
  double estimated_error() const { return estimated_error_; }

 private:
  struct FinishedRun {
    Resolution resolution;
    Restitution measured;
  };

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
  void note_irregularities(const FinishedImpact& run);
  std::size_t runs_needed() const;
  bool are_pair() const;
  double rounding(const FinishedImpact& run) const;
  double way_in(double step) const;
  std::optional<int> order() const;
  ConvergedValue convergence_of(const std::vector<Sample>& runs) const;
  void conclude(double noise, const ModelError& left_out);
  void add(const ModelError& left_out);
  void add_lost_of_spin(double lost);
  bool is_extrapolated() const;
  bool is_confirmed() const;
  bool may_agree_by_chance(const FinishedImpact& finest) const;
  bool may_be_confirmed() const;
  void refine_by_estimate();
  [[noreturn]] void give_up(const std::string& cause) const;

  Scene scene_;
  Rates rates_;
  double expected_time_;
  Resolution resolution_;
  Eigen::Index points_;  ///< of the disk
  double most_steps_ = 0.0;
  std::vector<Resolution> planned_;  ///< after the present one, the next one last
  std::vector<FinishedRun> runs_;    ///< of one method, from coarse to fine
  ModelError model_error_;           ///< of that method
  ImpactAnswer answer_;
  double estimated_error_ = std::numeric_limits<double>::quiet_NaN();
  double last_estimate_ = std::numeric_limits<double>::infinity();
  /// Refinements in turn that left the estimate as it was: as long as coarser runs are compared
  /// with, that may be due to them.
  int stagnations_ = 0;
  int failures_ = 0;  ///< runs that broke off
  int halvings_ = 0;  ///< runs whose step was reduced
  bool accepted_ = false;
  bool is_lifted_for_folds_ = false;
  bool erratic_ = false;           ///< the lattice folds or the wall is cut off
  bool irregular_ = false;         ///< contacts hop from bond to bond
  const char* likely_cause_ = "";  ///< of slow convergence, if known
};

}  // namespace impact
