#pragma once

#include "measure/contact_report.hpp"
#include "mechanics/system.hpp"

namespace impact {

/// What happened to the first body and, where it meets a second one, to that. The second report has
/// no samples: they are the first's with the opposite sign.
struct ContactReports {
  ContactReport on_first;
  ContactReport on_second;
};

/// Follows the contact force step by step and sums it up into reports.
class ContactRecorder {
 public:
  /// A point is listed as in contact when it is pushed with more than `contact_force`
  /// (M c²/R).
  ContactRecorder(const System& start, double contact_force);

  /// To be called after every step.
  void add_step(const System& system);

  /// The reports up to the present step; begins the next ones.
  ContactReports take(const System& system);

 private:
  double contact_force_;
  ForceSample last_;
  ContactReport report_;
};

}  // namespace impact
