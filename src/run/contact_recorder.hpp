#pragma once

#include "measure/contact_report.hpp"
#include "mechanics/simulation.hpp"

namespace impact {

/// Follows the wall force step by step and sums it up into reports.
class ContactRecorder {
 public:
  /// A point is listed as in contact when the wall pushes it with more than `contact_force`
  /// (M c²/R).
  ContactRecorder(const Simulation& start, double contact_force);

  /// To be called after every step.
  void add_step(const Simulation& simulation);

  /// The report up to the present step; begins the next one.
  ContactReport take(const Simulation& simulation);

 private:
  double contact_force_;
  ForceSample last_;
  ContactReport report_;
};

}  // namespace impact
