#pragma once

#include <array>
#include <limits>
#include <string>
#include <utility>

#include "measure/impact_analysis.hpp"

namespace impact {

/// The numbers of an impact that have an error of their own, by their names. `Numbers` is
/// Restitution or a message with such fields.
template <class Numbers>
constexpr auto impact_numbers() {
  using Number = std::pair<const char*, double Numbers::*>;
  return std::array<Number, 14>{{{"restitution", &Numbers::restitution},
                                 {"tangential_velocity_after", &Numbers::tangential_velocity_after},
                                 {"spin_after", &Numbers::spin_after},
                                 {"energy_restitution", &Numbers::energy_restitution},
                                 {"contact_begin", &Numbers::contact_begin},
                                 {"contact_end", &Numbers::contact_end},
                                 {"contact_duration", &Numbers::contact_duration},
                                 {"peak_force", &Numbers::peak_force},
                                 {"impulse", &Numbers::impulse},
                                 {"tangential_restitution", &Numbers::tangential_restitution},
                                 {"impulse_ratio", &Numbers::impulse_ratio},
                                 {"normal_energy", &Numbers::normal_energy},
                                 {"tangential_energy", &Numbers::tangential_energy},
                                 {"rotation_energy", &Numbers::rotation_energy}}};
}

/// Whether this number of an impact says something new only where the disk slides along the wall.
inline bool is_of_sliding(const std::string& name) {
  return name == "tangential_restitution" || name == "impulse_ratio" || name == "normal_energy" ||
         name == "tangential_energy" || name == "rotation_energy";
}

/// Whether a number is read off the forces at the steps: its error depends on how they happen to
/// fall, and shows no order.
inline bool is_read_off_steps(const std::string& name) {
  return name == "contact_begin" || name == "contact_end" || name == "contact_duration" ||
         name == "peak_force";
}

/// What an impact did to the disk, as all its runs together say.
struct ImpactAnswer {
  Restitution value;
  Restitution error;  ///< of each number, in its unit; NaN: not known
  /// How far e of the states of the last run may be from the true one; NaN: not known.
  double error_of_run = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace impact
