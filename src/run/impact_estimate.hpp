#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "measure/impact_answer.hpp"
#include "run/convergence.hpp"
#include "run/finished_impact.hpp"
#include "run/resolution.hpp"

namespace impact {

/// As many as confirm a limit.
constexpr std::size_t kRunsThatShowAnOrder = 4;

/// What several runs of an impact by one method say together, each finer than the one before: the
/// answer, e and all other numbers, and its error.
///
/// It is what converged() gives for the last runs, three at least: extrapolated to zero step if
/// they show the order of the method, else that of the finest run. Two do where the second has half
/// the steps of the first and differs by no more than a fiftieth of numerics.error, which then is
/// the error. A limit of three runs is good up to a tenth of numerics.error, but for what a model
/// leaves out; above that a fourth run has to confirm it, and then it is good up to half of
/// numerics.error. An order is not looked for
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
/// Added to the error are
/// - what the wall does before the start and after the end of a run, Run::tail_error(),
/// - what passing from bond to bond leaves open, since a step notices it late: its possible effect
///   on e, times a v h,
/// - rounding, 16 ε √steps (ε: spacing of doubles): two to ten times the scatter of e with other
///   wall.V0, v = 10⁻⁶ … 10⁻² c; where steps solve for damped velocities, 16 ε steps, since their
///   rounding goes to one side: 4.5 ε a step was seen;
/// - what `reduced` or `modal` leave out, see left_out() and ModalCorrection.
/// Spins are those at the end of the run. What damping takes of them in flight, from the end of the
/// contact on, at most all energy that is not seen at the end, counts as an error of theirs and of
/// what depends on them; no finer runs are asked for it.
class ImpactEstimate {
 public:
  /// `spacing` of the points of the disk, R.
  ImpactEstimate(Scene scene, double spacing);

  /// Takes the numbers of a single run as they are; their errors are not known.
  void take(const Restitution& measured);

  /// Looks for what keeps errors from following an order, in a run by any method.
  void note_irregularities(const FinishedImpact& run);
  /// A run that is finer than the one before it.
  void add(const Resolution& resolution, const Restitution& measured) {
    runs_.push_back({resolution, measured});
  }
  /// Begins anew.
  void clear() { runs_.clear(); }
  bool is_empty() const { return runs_.empty(); }

  std::size_t runs_needed() const;
  /// Whether there are as many, or a pair.
  bool is_enough() const;
  /// Two runs that may bear each other out, since one has at least twice as many steps.
  bool are_pair() const;

  /// Finds the answer, once there are enough runs.
  void conclude(const FinishedImpact& latest);
  /// Whether it is good enough, but for chance.
  bool is_good() const;
  /// Whether more than numerics.error of what was extrapolated is in doubt, and one more run is to
  /// bear the limit out: if that exceeds 500 times numerics.error, limits are asked to agree twice;
  /// those of three runs are also if the term after the two that they are fitted to may do so, as
  /// the stiffness of the wall says, or, where the wall is hard over the spacing of the points, all
  /// that was extrapolated.
  bool may_agree_by_chance(const FinishedImpact& finest) const;
  /// Whether a fourth run near the others may show an order that three do not.
  bool may_be_confirmed() const;
  bool is_extrapolated() const;

  const ImpactAnswer& answer() const { return answer_; }
  /// Relative, of e, or that of β or of the spin where it is greater.
  double error() const { return error_; }
  /// Of slow convergence, if known; as the end of a sentence.
  const char* likely_cause() const { return likely_cause_; }

 private:
  struct FinishedRun {
    Resolution resolution;
    Restitution measured;
  };

  IntegratorKind integrator() const { return runs_.back().resolution.integrator; }
  double rounding(const FinishedImpact& run) const;
  double way_in(double step) const;
  std::optional<int> order() const;
  ConvergedValue convergence_of(const std::vector<Sample>& runs) const;
  void add(const ModelError& left_out);
  double greatest_error() const;
  void add_lost_of_spin(double lost);
  bool is_confirmed() const;

  Scene scene_;
  double spacing_;
  std::vector<FinishedRun> runs_;  ///< of one method, from coarse to fine
  ImpactAnswer answer_;
  double error_ = std::numeric_limits<double>::quiet_NaN();
  double noise_ = 0.0;      ///< the part of it that finer steps do not take away
  double left_out_ = 0.0;   ///< the part that the model leaves out
  bool erratic_ = false;    ///< the lattice folds or the wall is cut off
  bool irregular_ = false;  ///< contacts hop from bond to bond
  const char* likely_cause_ = "";
};

}  // namespace impact
