#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <memory>

#include "mechanics/force_field.hpp"
#include "mechanics/state.hpp"
#include "test_lattices.hpp"

namespace impact {

/// Spectral radius of one step, of length 1, for the mode ẍ = −ω² x − γ ẋ, as the integrator makes
/// it: the distance x of two points on a line, where the force of a bond is linear. For integrators
/// that carry nothing but (x, v) from step to step.
template <class Integrator>
double spectral_radius(double omega_squared, double gamma) {
  constexpr double kMass = 0.5;
  constexpr double kSize = 1.0 / 16.0;  // the bond keeps its direction
  ForceField field{
      BondForces(two_points(), {omega_squared * kMass / 2.0, 0.0, gamma * kMass / 2.0}), kMass};
  field.unstrained = std::make_shared<const PointArray>(two_points().points);
  Eigen::Matrix2d step;
  for (int column = 0; column < 2; ++column) {
    State state{0.0, 0, two_points().points, PointArray::Zero(2, 2)};
    (column == 0 ? state.position : state.velocity)(1, 0) += kSize;
    (column == 0 ? state.position : state.velocity)(0, 0) -= kSize;
    Integrator integrator;
    integrator.restart(field, state);
    integrator.step(field, state, 1.0);
    step(0, column) = (state.position(1, 0) - state.position(0, 0) - 1.0) / (2.0 * kSize);
    step(1, column) = (state.velocity(1, 0) - state.velocity(0, 0)) / (2.0 * kSize);
  }
  return step.eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace impact
