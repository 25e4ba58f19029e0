#include "nodes/program.hpp"
#include "nodes/viewer_node.hpp"

int main(int argc, char** argv) {
  return impact::run_node(argc, argv, "viewer_node", [] {
    impact::ViewerNode().run();
    return 0;
  });
}
