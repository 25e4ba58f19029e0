#include "nodes/analysis_node.hpp"
#include "nodes/node_parameters.hpp"
#include "nodes/parameter_server.hpp"
#include "nodes/program.hpp"

int main(int argc, char** argv) {
  const impact::NodeDescription description{
      "analysis_node",
      "Measures strain and coefficient of restitution of the runs that it hears, and fits the laws "
      "of contact and impact to a series.",
      "  in   lattice, particle_states, contact_forces, run_status\n"
      "  out  strain, restitution, law_fit, acknowledged\n",
      impact::parameter_list(impact::analysis_node_parameters(), {}),
      [](const auto& keys) { impact::check_parameters(impact::analysis_node_parameters(), keys); }};
  return impact::run_node(argc, argv, description, [] {
    impact::AnalysisNodeParameters parameters;
    impact::read_parameters(impact::analysis_node_parameters(), impact::private_parameters(),
                            parameters);
    return impact::AnalysisNode(parameters).run() ? 0 : 1;
  });
}
