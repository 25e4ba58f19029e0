#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "measure/impact_analysis.hpp"
#include "mechanics/body.hpp"

namespace impact {

/// The numbers of an impact that have an error of their own, by their names. `Numbers` is
/// Restitution or a message with such fields.
template <class Numbers>
constexpr auto impact_numbers() {
  using Number = std::pair<const char*, double Numbers::*>;
  return std::array<Number, 25>{
      {{"restitution", &Numbers::restitution},
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
       {"rotation_energy", &Numbers::rotation_energy},
       {"wall_velocity_after", &Numbers::wall_velocity_after},
       {"wall_tangential_velocity_after", &Numbers::wall_tangential_velocity_after},
       {"wall_spin_after", &Numbers::wall_spin_after},
       {"wall2_velocity_after", &Numbers::wall2_velocity_after},
       {"wall2_tangential_velocity_after", &Numbers::wall2_tangential_velocity_after},
       {"wall2_spin_after", &Numbers::wall2_spin_after},
       {"wall3_velocity_after", &Numbers::wall3_velocity_after},
       {"wall3_tangential_velocity_after", &Numbers::wall3_tangential_velocity_after},
       {"wall3_spin_after", &Numbers::wall3_spin_after},
       {"momentum_passed_on", &Numbers::momentum_passed_on},
       {"restitution_of_ends", &Numbers::restitution_of_ends}}};
}

/// Whether this number of an impact says something new only where the disk slides along the wall.
inline bool is_of_sliding(const std::string& name) {
  return name == "tangential_restitution" || name == "impulse_ratio" || name == "normal_energy" ||
         name == "tangential_energy" || name == "rotation_energy";
}

/// The number of the disk that was met whose number of an impact this is; 0: it is no such number.
inline std::size_t disk_of(const std::string& name) {
  for (std::size_t body = 1; body < kMostBodies; ++body) {
    if (name.rfind(name_of_body(body) + "_", 0) == 0) return body;
  }
  return 0;
}

/// Whether this number of an impact says something new only where the disk meets several others.
inline bool is_of_row(const std::string& name) {
  return name == "momentum_passed_on" || name == "restitution_of_ends";
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
