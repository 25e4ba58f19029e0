#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "measure/contact_time.hpp"
#include "measure/impact_analysis.hpp"
#include "mechanics/body_motion.hpp"
#include "scene/scene.hpp"

namespace impact {

/// The files in which lammps_script() has LAMMPS say what happens.
constexpr std::array<const char*, 2> kLammpsOutput{"force.txt", "motion.txt"};

/// What LAMMPS wrote of an impact, see lammps_script().
struct LammpsCourse {
  struct Look {
    std::uint64_t step = 0;
    BodyMotion disk;
    double kinetic_energy = 0.0;  ///< M c²
    double bond_energy = 0.0;     ///< M c²
  };
  std::vector<ForceSample> forces;  ///< of every step from 0 on
  std::vector<Look> looks;          ///< from step 0 on
};

/// Reads force.txt and motion.txt of the folder. A half-written last line does not count: LAMMPS
/// may still be at work. `step` in R/c.
/// @throw InputError with file and line number for what lammps_script() does not write, and where
/// steps are missing.
LammpsCourse read_lammps_course(const std::filesystem::path& folder, double step);

/// What an impact in LAMMPS came to.
struct LammpsAnswer {
  Restitution impact;
  double energy_error = 0.0;  ///< as Run::energy_error(), of all looks
  std::uint64_t steps = 0;    ///< up to the last look
  std::vector<std::string> flags;
};

/// `scene` as scene_for_lammps(). Flags: starts_in_wall, energy_error and not_separated, as of Run;
/// separated is what has_left() calls so.
LammpsAnswer answer_of(const LammpsCourse& course, const Scene& scene);

}  // namespace impact
