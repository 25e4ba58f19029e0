#include "nodes/node_parameters.hpp"
#include "nodes/parameter_server.hpp"
#include "nodes/program.hpp"
#include "nodes/replay_node.hpp"

namespace impact {
namespace {

ReplayNodeParameters parameters_of(const FlatTree& keys) {
  ReplayNodeParameters parameters;
  read_parameters(replay_node_parameters(), keys, parameters);
  return parameters;
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  const impact::NodeDescription description{
      "replay_node", "Publishes once more what a simulation has published, as a bag has it.",
      "  out  lattice, particle_states, contact_forces, run_status, scalars, those of wall/\n"
      "  in   acknowledged\n",
      impact::parameter_list(impact::replay_node_parameters(), {}),
      [](const auto& keys) { impact::check_bag(impact::parameters_of(keys)); }};
  return impact::run_node(argc, argv, description, [] {
    impact::ReplayNode(impact::parameters_of(impact::private_parameters())).run();
    return 0;
  });
}
