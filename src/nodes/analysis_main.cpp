#include "nodes/analysis_node.hpp"
#include "nodes/node_parameters.hpp"
#include "nodes/parameter_server.hpp"
#include "nodes/program.hpp"

int main(int argc, char** argv) {
  return impact::run_node(argc, argv, "analysis_node", [] {
    impact::AnalysisNodeParameters parameters;
    impact::read_parameters(impact::analysis_node_parameters(), impact::private_parameters(),
                            parameters);
    return impact::AnalysisNode(parameters).run() ? 0 : 1;
  });
}
