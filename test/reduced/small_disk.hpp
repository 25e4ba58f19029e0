#pragma once

#include <memory>

#include "lattice/placement.hpp"
#include "lattice/triangulation.hpp"
#include "mechanics/body_motion.hpp"
#include "mechanics/force_field.hpp"
#include "statics/compliance.hpp"

namespace impact {

constexpr double kA = 300.0;  // of the wall, 1/R

/// A disk of some points on the potential wall.
struct SmallDisk {
  explicit SmallDisk(int points = 60, double k_a = 1.0)
      : lattice(triangulated_lattice(place_in_disk({points, Placement::kBlueNoise, true}, 3))),
        arm(about_the_centre(lattice.points)),
        compliance(std::make_shared<Compliance>(lattice)),
        field{BondForces(lattice, {k_a, 0.0, 0.0}), 1.0 / points} {
    field.wall.emplace(kA, kA / points);
  }

  /// Coming down without spin.
  State above(double lowest, double velocity) const {
    State state;
    state.position = lattice.points;
    state.position.col(1) += lowest - lattice.points.col(1).minCoeff();
    state.velocity = PointArray::Zero(lattice.points.rows(), 2);
    state.velocity.col(1) = -velocity;
    return state;
  }

  Lattice lattice;
  PointArray arm;
  std::shared_ptr<Compliance> compliance;
  ForceField field;
};

}  // namespace impact
