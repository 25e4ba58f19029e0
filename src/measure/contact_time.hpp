#pragma once

#include <deque>
#include <limits>

namespace impact {

/// The wall force at the end of one step.
struct ForceSample {
  double time;   ///< R/c
  double force;  ///< total force of the wall along y, M c²/R
};

/// The force counts as contact where it exceeds this fraction of its peak.
constexpr double kContactFraction = 1.0e-3;

/// Finds, from the force at every step, its peak and the first and last instant at which it
/// crosses kContactFraction of the peak.
///
/// Between steps the peak is that of the parabola through the largest force and its neighbours. A
/// crossing is where the cubic through the logarithms of four forces crosses: two on either side;
/// of fewer, or where one is not positive, the line through two. On a steady approach to the
/// potential wall the logarithm is linear. So the errors go with the third power of the
/// step, and how the steps happen to fall hardly shows. Keeps only the steps of the rise that may
/// still turn out to be the first crossing.
class ContactTime {
 public:
  void add(const ForceSample& sample);

  double peak_force() const;                           ///< M c²/R; NaN before the first sample
  double begin() const;                                ///< R/c; NaN without contact
  double end() const;                                  ///< R/c; NaN while contact lasts
  double duration() const { return end() - begin(); }  ///< R/c

 private:
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  static constexpr ForceSample kNone{kNaN, kNaN};

  /// A step and the samples beside it.
  struct Step {
    ForceSample before = kNone;
    ForceSample from = kNone;
    ForceSample to = kNone;
    ForceSample after = kNone;
  };

  double crossing(const Step& step) const;
  /// By the largest force at a step.
  double threshold() const {
    return rise_.empty() ? kNaN : kContactFraction * rise_.back().to.force;
  }

  Step last_;
  std::deque<Step> rise_;  ///< each to the largest force so far
  Step fall_;
};

}  // namespace impact
