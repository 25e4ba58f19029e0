#include "nodes/node_parameters.hpp"
#include "nodes/parameter_server.hpp"
#include "nodes/program.hpp"
#include "nodes/recorder_node.hpp"

int main(int argc, char** argv) {
  return impact::run_node(argc, argv, "recorder_node", [] {
    impact::RecorderNodeParameters parameters;
    impact::read_parameters(impact::recorder_node_parameters(), impact::private_parameters(),
                            parameters);
    impact::RecorderNode(parameters).run();
    return 0;
  });
}
