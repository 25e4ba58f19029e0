#pragma once

#include <cstddef>
#include <vector>

#include "measure/contact_report.hpp"
#include "mechanics/system.hpp"

namespace impact {

/// What happened to each body. Only the first report has samples: those of the force on the first
/// body.
struct ContactReports {
  ContactReport on_first;
  std::vector<ContactReport> on_others;

  /// By the number of the body; 0: the first.
  const ContactReport& on(std::size_t body) const {
    return body == 0 ? on_first : on_others[body - 1];
  }
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
  void enter(const System& system, std::size_t number, ContactReport& report) const;

  double contact_force_;
  ForceSample last_;
  ContactReport report_;
};

}  // namespace impact
