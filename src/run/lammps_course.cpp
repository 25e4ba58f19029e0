#include "run/lammps_course.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "lattice/input_error.hpp"
#include "measure/flags.hpp"
#include "run/lammps_scene.hpp"

namespace impact {
namespace {

using Numbers = std::vector<double>;

Numbers numbers_in(const std::string& line, std::size_t columns, const std::string& place) {
  std::istringstream words(line);
  Numbers numbers(columns);
  for (double& number : numbers) words >> number;
  if (!words || !(words >> std::ws).eof()) {
    throw InputError(fmt::format("{}: expected {} finite numbers", place, columns));
  }
  return numbers;
}

/// Calls `use` with the step and the numbers behind it of each line; the steps are 0, `interval`,
/// 2 `interval`, ….
template <class Use>
void read_table(const std::filesystem::path& path, std::uint64_t interval, std::size_t columns,
                const Use& use) {
  std::ifstream file(path);
  if (!file) throw InputError(fmt::format("{}: cannot be read", path.string()));
  std::uint64_t step = 0;
  int number = 0;
  for (std::string line; std::getline(file, line) && !file.eof();) {
    ++number;
    if (line.rfind('#', 0) == 0) continue;
    const std::string place = fmt::format("{}:{}", path.string(), number);
    const Numbers numbers = numbers_in(line, columns + 1, place);
    if (numbers[0] != static_cast<double>(step)) {
      throw InputError(fmt::format("{}: step {}, expected {}", place, numbers[0], step));
    }
    use(step, numbers);
    step += interval;
  }
  if (step == 0) throw InputError(fmt::format("{}: has no step", path.string()));
}

double wall_energy(const LammpsCourse& course, const LammpsCourse::Look& look, const Scene& scene) {
  return course.forces[look.step].force / scene.wall.a;
}

double energy(const LammpsCourse& course, const LammpsCourse::Look& look, const Scene& scene) {
  return look.kinetic_energy + look.bond_energy + wall_energy(course, look, scene);
}

/// Of all looks, over the largest energy.
double energy_error(const LammpsCourse& course, const Scene& scene) {
  const double at_start = energy(course, course.looks.front(), scene);
  double largest = 0.0;
  double deviation = 0.0;
  for (const LammpsCourse::Look& look : course.looks) {
    const double now = energy(course, look, scene);
    largest = std::max(largest, now);
    deviation = std::max(deviation, std::abs(now - at_start));
  }
  return deviation / largest;
}

bool has_left(const LammpsCourse& course, const Scene& scene) {
  const LammpsCourse::Look& last = course.looks.back();
  return has_left(scene, last.disk.centre.y() - course.looks.front().disk.centre.y(),
                  last.disk.velocity.y(), wall_energy(course, last, scene));
}

std::vector<std::string> flags(const LammpsCourse& course, const Scene& scene, double energy_error,
                               bool separated) {
  const double v = scene.impact.normal_velocity();
  const double at_start = wall_energy(course, course.looks.front(), scene);
  std::vector<std::string> flags;
  if (at_start > scene.numerics.error * 0.5 * v * v) {
    flags.emplace_back(name_of(Flag::kStartsInWall));
  }
  if (!(energy_error <= scene.numerics.error)) flags.emplace_back(name_of(Flag::kEnergyError));
  if (!separated) flags.emplace_back(name_of(Flag::kNotSeparated));
  return flags;
}

}  // namespace

LammpsCourse read_lammps_course(const std::filesystem::path& folder, double step) {
  LammpsCourse course;
  read_table(folder / "force.txt", 1, 1, [&](std::uint64_t count, const Numbers& row) {
    course.forces.push_back({step * static_cast<double>(count), row[1]});
  });
  read_table(folder / "motion.txt", kLammpsLook, 8, [&](std::uint64_t count, const Numbers& row) {
    const BodyMotion disk{{row[1], row[2]}, {row[3], row[4]}, row[5], row[6]};
    course.looks.push_back({count, disk, row[7], row[8]});
  });
  if (course.looks.back().step >= course.forces.size()) {
    throw InputError(fmt::format("{}: ends at step {}, motion.txt at step {}",
                                 (folder / "force.txt").string(), course.forces.size() - 1,
                                 course.looks.back().step));
  }
  return course;
}

LammpsAnswer answer_of(const LammpsCourse& course, const Scene& scene) {
  ImpactAnalysis analysis;
  analysis.add(course.looks.front().disk);
  analysis.add(course.looks.back().disk);
  ContactReport report;
  report.samples = course.forces;
  analysis.add(report);
  const bool separated = has_left(course, scene);
  const double error = energy_error(course, scene);
  return {analysis.restitution(separated), error, course.looks.back().step,
          flags(course, scene, error, separated)};
}

}  // namespace impact
