#include <malloc.h>

#include "nodes/node_parameters.hpp"
#include "nodes/parameter_server.hpp"
#include "nodes/program.hpp"
#include "nodes/simulation_node.hpp"
#include "scene/keys.hpp"
#include "scene/scene_parameters.hpp"
#include "scene/short_keys.hpp"

namespace impact {
namespace {

/// The messages that wait for the socket come and go by megabytes. What one leaves is kept for the
/// next, since memory that was given back to the system costs a page fault every 4 kB.
void keep_freed_memory() {
  constexpr int kKept = 64 << 20;  // bytes
  constexpr int kLargest =
      32 << 20;  // the largest piece that is kept, and the most that glibc takes
  mallopt(M_TRIM_THRESHOLD, kKept);
  mallopt(M_MMAP_THRESHOLD, kLargest);
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  const impact::NodeDescription description{
      "simulation_node",
      "Simulates a scene, or a series of them, and publishes lattice, states and forces.",
      "  out  lattice, particle_states, contact_forces, run_status, scalars; with an elastic wall\n"
      "       also wall/lattice, wall/particle_states, wall/contact_forces\n"
      "  in   acknowledged\n",
      impact::parameter_list(impact::simulation_node_parameters(), {}) +
          "\nand the keys of a scene: impact collision --keys shows those of collision.yaml.\n",
      [](const auto& keys) {
        impact::check_parameters(impact::simulation_node_parameters(), keys);
      }};
  return impact::run_node(argc, argv, description, [] {
    impact::keep_freed_memory();
    impact::FlatTree keys = impact::private_parameters();
    impact::SimulationNodeParameters parameters;
    impact::read_parameters(impact::simulation_node_parameters(),
                            impact::take_keys(keys, impact::simulation_node_parameters()),
                            parameters);
    keys.merge(impact::parse_keys(parameters.scene_yaml, "scene_yaml"));
    impact::override_keys(keys, parameters.assignments);
    std::vector<impact::Scene> series = impact::parse_series(
        keys, impact::key_names(impact::simulation_node_parameters(), parameters));
    impact::Compositions compositions = impact::check_series(parameters, series);
    impact::SimulationNode node(parameters, std::move(series), std::move(compositions));
    return node.run_series() ? 0 : 1;
  });
}
