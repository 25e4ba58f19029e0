#include "nodes/node_parameters.hpp"
#include "nodes/parameter_server.hpp"
#include "nodes/program.hpp"
#include "nodes/recorder_node.hpp"

int main(int argc, char** argv) {
  const impact::NodeDescription description{
      "recorder_node", "Records all data and results of a series in a bag, and loses none.",
      "  in   lattice, particle_states, contact_forces, run_status, those of wall/, scalars,\n"
      "       strain, restitution, law_fit, acknowledged\n"
      "  out  acknowledged\n",
      impact::parameter_list(impact::recorder_node_parameters(), {}),
      [](const auto& keys) { impact::check_parameters(impact::recorder_node_parameters(), keys); }};
  return impact::run_node(argc, argv, description, [] {
    impact::RecorderNodeParameters parameters;
    impact::read_parameters(impact::recorder_node_parameters(), impact::private_parameters(),
                            parameters);
    impact::RecorderNode(parameters).run();
    return 0;
  });
}
