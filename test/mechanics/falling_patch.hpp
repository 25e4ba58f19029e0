#pragma once

#include "mechanics/force_field.hpp"
#include "mechanics/state.hpp"
#include "test_lattices.hpp"

namespace impact {

/// A damped patch of the triangular lattice that falls on the wall.
struct FallingPatch {
  FallingPatch() {
    field.wall.emplace(10.0, 0.1);
    state = {0.0, 0, lattice.points, PointArray::Zero(16, 2)};
    state.position.col(1) += 0.5;
    state.velocity.col(1).setConstant(-0.1);
  }

  template <class Integrator>
  void run(Integrator&& integrator, int steps = 20) {
    integrator.restart(field, state);
    for (int k = 0; k < steps; ++k) integrator.step(field, state, 0.2);
  }

  Lattice lattice = triangular_patch(4);
  ForceField field{BondForces(lattice, {1.0, 0.0, 0.1}), 1.0 / 16.0};
  State state;
};

}  // namespace impact
