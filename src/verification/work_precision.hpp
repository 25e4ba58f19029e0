#pragma once

#include <filesystem>
#include <string>

#include "verification/timed_scene.hpp"

namespace impact {

/// Where errors against run times are written, and how much is measured.
struct WorkPrecision {
  std::filesystem::path folder;
  bool quick = false;  ///< small lattices, few settings: a test of the program
  Effort effort;
};

/// Every integrator over its range of steps or tolerances in five scenes: errors against run time
/// and force evaluations, relative to a reference on which two methods agree
/// (work_precision_SCENE.csv, references.csv), and for each scene and error what is fastest
/// (best_for_error.csv), which is told on stdout too.
///
/// Kinds of rows: `run` is one run up to a time that all share, all from the same start; `bare` is
/// the answer of one run with the step or tolerance that is known from there to keep the error, and
/// the next finer one; `verified` is the answer of as many runs as the error control of
/// `error: ε` asks for.
void measure_scenes(const WorkPrecision& task);

/// Restitution against the number of points, for lattices of one material (discretisation.csv).
void measure_discretisation(const WorkPrecision& task);

/// `auto` against rk8pd and velocity Verlet over speeds and lattices (timing.csv; medians on
/// stdout).
void compare_times(const WorkPrecision& task);

/// Model and number of its processors.
std::string machine();

}  // namespace impact
