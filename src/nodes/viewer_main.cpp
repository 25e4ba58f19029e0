#include "nodes/program.hpp"
#include "nodes/viewer_node.hpp"

int main(int argc, char** argv) {
  const impact::NodeDescription description{
      "viewer_node",
      "Draws a simulation, live or replayed, for rviz.",
      "  in   lattice, particle_states, contact_forces, run_status, wall/lattice,\n"
      "       wall/particle_states\n"
      "  out  markers, contact_wrench, /tf_static, /diagnostics\n",
      {}};
  return impact::run_node(argc, argv, description, [] {
    impact::ViewerNode().run();
    return 0;
  });
}
