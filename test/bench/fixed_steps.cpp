// The steps of a scene and nothing else, for the comparison with other programs: their wall time as
// YAML on stdout and, if asked for, where the points are in the end.

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "kernels/kernels.hpp"
#include "lattice/input_error.hpp"
#include "mechanics/simulation.hpp"
#include "output/program.hpp"
#include "run/compose.hpp"
#include "run/make_integrator.hpp"
#include "run/resolution.hpp"
#include "scene/keys.hpp"
#include "scene/scene_parameters.hpp"
#include "scene/short_keys.hpp"

namespace impact {
namespace {

Scene scene_of(const std::string& file, const std::vector<std::string>& assignments) {
  FlatTree keys = load_keys(file);
  override_keys(keys, assignments);
  return parse_scene(keys);
}

Simulation simulation_of(const Scene& scene, Composition composition) {
  const double sound_speed = composition.rates.sound_speed;
  return {std::move(composition.field), std::move(composition.initial), composition.rates.lattice,
          composition.resolution.step, make_integrator(scene, composition.resolution, sound_speed)};
}

const Kernels& kernels_named(const std::string& name) {
  for (const Kernels* const kernels : {&kAvx512Kernels, &kAvx2Kernels, &kPlainKernels}) {
    if (kernels->name == name && can_run(*kernels)) return *kernels;
  }
  throw InputError(fmt::format("--instructions: got {}, not on this processor", name));
}

/// Wall time in s.
double time_of(Simulation& simulation, std::uint64_t steps) {
  const auto start = std::chrono::steady_clock::now();
  for (std::uint64_t step = 0; step < steps; ++step) simulation.step();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// A line a point, x and y.
void write_positions(const PointArray& position, const std::string& path) {
  std::ofstream file(path);
  for (const auto& point : position.rowwise()) file << fmt::format("{} {}\n", point(0), point(1));
  if (!file.flush()) throw std::runtime_error(fmt::format("{} cannot be written", path));
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  CLI::App app("Makes steps of a scene; their number and wall time (s) as YAML.", "fixed_steps");
  std::string scene_file;
  std::uint64_t steps = 0;
  std::vector<std::string> assignments;
  std::string instructions;
  std::string positions_file;
  app.add_option("scene", scene_file, "scene file")->required();
  app.add_option("steps", steps, "how many")->required();
  app.add_option("assignments", assignments, "key=value, replaces that key of the scene");
  app.add_option("--instructions", instructions, "AVX-512, AVX2 or plain; the best unless given");
  app.add_option("--positions", positions_file, "file to write the final positions to");
  return impact::run_tool(app, argc, argv, [&] {
    if (!instructions.empty()) impact::choose_kernels(impact::kernels_named(instructions));
    const impact::Scene scene = impact::scene_of(scene_file, assignments);
    impact::Composition composition = impact::compose(scene);
    const std::size_t bonds = composition.bodies->disk().bonds.size();
    impact::Simulation simulation = impact::simulation_of(scene, std::move(composition));
    const double seconds = impact::time_of(simulation, steps);
    if (simulation.halvings() > 0) throw std::runtime_error("the wall was too stiff for the step");
    fmt::print("steps: {}\nbonds: {}\nseconds: {}\n", steps, bonds, seconds);
    if (!positions_file.empty()) {
      impact::write_positions(simulation.state().position, positions_file);
    }
  });
}
