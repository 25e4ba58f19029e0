#include "nodes/node_parameters.hpp"
#include "nodes/parameter_server.hpp"
#include "nodes/program.hpp"
#include "nodes/simulation_node.hpp"
#include "scene/scene_parameters.hpp"

int main(int argc, char** argv) {
  return impact::run_node(argc, argv, "simulation_node", [] {
    impact::FlatTree keys = impact::private_parameters();
    impact::SimulationNodeParameters parameters;
    impact::read_parameters(impact::simulation_node_parameters(),
                            impact::take_keys(keys, impact::simulation_node_parameters()),
                            parameters);
    keys.merge(impact::parse_keys(parameters.scene_yaml, "scene_yaml"));
    for (const std::string& assignment : parameters.assignments) {
      impact::override_key(keys, assignment);
    }
    std::vector<impact::Scene> series = impact::parse_series(
        keys, impact::key_names(impact::simulation_node_parameters(), parameters));
    impact::Compositions compositions = impact::check_series(parameters, series);
    impact::SimulationNode node(parameters, std::move(series), std::move(compositions));
    return node.run_series() ? 0 : 1;
  });
}
