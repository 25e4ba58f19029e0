#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "mechanics/simulation.hpp"
#include "mechanics/velocity_verlet.hpp"
#include "test_lattices.hpp"

namespace impact {

/// A hexagon of seven points standing on a corner, thrown at a rectangular patch of the triangular
/// lattice. Bonds of length 1, masses of 1/7 in both.
struct TwoBodies {
  static constexpr Eigen::Index kDiskPoints = 7;
  static constexpr double kMass = 1.0 / 7.0;
  static constexpr int kColumns = 8;
  static constexpr int kRows = 4;

  /// The corner starts at height 0.3 above the patch, over this place on its surface from 0 to 7.
  explicit TwoBodies(double place, const Eigen::Array2d& velocity,
                     GapMeasure measure = GapMeasure::kNormal, double a = 40.0, double eta = 0.0)
      : lattice(joined(hexagon(), triangular_patch(kColumns, kRows))),
        field{BondForces(lattice, {1.0, 0.5, eta}), kMass} {
    field.others = {Body{kDiskPoints, kColumns * kRows, false}};
    state.position = lattice.points;
    const double top = lattice.points.col(1).maxCoeff();
    const double first = lattice.points(row(0, kRows - 1), 0);
    state.position.topRows(kDiskPoints).rowwise() +=
        Eigen::Array2d(first + place, top + 1.3).transpose();
    state.velocity = PointArray::Zero(lattice.points.rows(), 2);
    state.velocity.topRows(kDiskPoints).rowwise() += velocity.transpose();
    std::vector<std::int32_t> points(kDiskPoints);
    std::iota(points.begin(), points.end(), 0);
    std::vector<std::int32_t> surface;
    for (int column = 0; column < kColumns; ++column) surface.push_back(row(column, kRows - 1));
    field.elastic_wall.emplace(Repulsion(a, 0.1), 1.0, measure, std::move(points),
                               std::move(surface), state.position);
  }

  /// Rows of the patch's lowest points.
  static std::vector<std::int32_t> bottom() {
    std::vector<std::int32_t> points;
    for (int column = 0; column < kColumns; ++column) points.push_back(row(column, 0));
    return points;
  }

  Spectrum spectrum() const { return lattice_spectrum(lattice, field.bonds.law(), kMass); }

  template <template <class> class I = BasicVelocityVerlet>
  Simulation simulation(double step) const {
    return Simulation(field, state, spectrum(), step, std::make_unique<I<ForceField>>());
  }

  Lattice lattice;
  ForceField field;
  State state;

 private:
  static std::int32_t row(int column, int row) {
    return static_cast<std::int32_t>(kDiskPoints) + row * kColumns + column;
  }

  /// About the origin; the point 1 is the lowest.
  static Lattice hexagon() {
    PointArray points = PointArray::Zero(kDiskPoints, 2);
    std::vector<Bond> bonds;
    for (int k = 1; k <= 6; ++k) {
      const double angle = (k - 1) * M_PI / 3.0 - M_PI / 2.0;
      points.row(k) << std::cos(angle), std::sin(angle);
      bonds.push_back({0, k});
      bonds.push_back({std::min(k, k % 6 + 1), std::max(k, k % 6 + 1)});
    }
    return make_lattice(points, bonds);
  }
};

}  // namespace impact
