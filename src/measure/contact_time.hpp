#pragma once

#include <deque>
#include <limits>
#include <utility>

namespace impact {

/// The wall force at the end of one step.
struct ForceSample {
  double time;   ///< R/c
  double force;  ///< total force of the wall along y, M c²/R
};

/// The force counts as contact where it exceeds this fraction of its peak.
constexpr double kContactFraction = 1.0e-3;

/// Finds, from the force at every step, its peak and the first and last instant at which it
/// crosses kContactFraction of the peak. Between two steps the force is taken as exponential in
/// time, which it is for a steady approach to the potential wall. Keeps only the steps of the rise
/// that may still turn out to be the first crossing.
class ContactTime {
 public:
  void add(const ForceSample& sample);

  double peak_force() const { return peak_; }          ///< M c²/R; NaN before the first sample
  double begin() const;                                ///< R/c; NaN without contact
  double end() const;                                  ///< R/c; NaN while contact lasts
  double duration() const { return end() - begin(); }  ///< R/c

 private:
  using Step = std::pair<ForceSample, ForceSample>;
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

  double crossing(const Step& step) const;
  double threshold() const { return kContactFraction * peak_; }

  double peak_ = kNaN;
  ForceSample last_{kNaN, 0.0};
  std::deque<Step> rise_;
  Step fall_{{kNaN, kNaN}, {kNaN, kNaN}};
};

}  // namespace impact
