#include "statics/flexibility.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>
#include <cmath>
#include <cstdint>
#include <random>

#include "lattice/placement.hpp"
#include "lattice/triangulation.hpp"
#include "mechanics/bond_forces.hpp"
#include "mechanics/spectrum.hpp"

namespace impact {
namespace {

Lattice triangle() {
  PointArray points(3, 2);
  points << 0.0, 0.0, 1.0, 0.0, 0.5, std::sqrt(0.75);
  return make_lattice(points, {{0, 1}, {0, 2}, {1, 2}});
}

/// The stiffness has the eigenvalues 3/2, twice, and 3 besides the rigid motions, and by symmetry
/// each point a third of the trace of its inverse, 2/1.5 + 1/3, in equal parts along x and y in the
/// two modes of 3/2, and along its radius in the third: 2/9 + 1/9. The mass of a point is 1/3.
TEST(Flexibility, OfATriangle) {
  const Flexibility flexibility = computed_flexibility(triangle());
  EXPECT_NEAR(flexibility.compliance, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(flexibility.lowest_frequency, std::sqrt(3.0 / (2.0 / 1.5 + 1.0 / 3.0)), 1e-12);
  EXPECT_LT(flexibility.lowest_frequency, std::sqrt(3.0 * 1.5));
}

/// A square without diagonals is sheared by no force, and so is a chain.
TEST(Flexibility, OfALatticeThatIsNotStiffIsInfinite) {
  PointArray square(4, 2);
  square << 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0;
  const Flexibility flexibility =
      computed_flexibility(make_lattice(square, {{0, 1}, {1, 2}, {2, 3}, {0, 3}}));
  EXPECT_TRUE(std::isinf(flexibility.compliance));
  EXPECT_EQ(flexibility.lowest_frequency, 0.0);
}

/// Bonds twice as long in a lattice twice as large: the same linear response.
TEST(Flexibility, DoesNotDependOnSizePlaceAndAngle) {
  const Lattice lattice = triangulated_lattice(place_in_disk({30}, 1));
  PointArray moved(30, 2);
  moved.col(0) = 3.0 - 2.0 * lattice.points.col(1);
  moved.col(1) = -1.0 + 2.0 * lattice.points.col(0);
  const Flexibility one = computed_flexibility(lattice);
  const Flexibility other = computed_flexibility(make_lattice(moved, lattice.bonds));
  EXPECT_NEAR(other.compliance, one.compliance, 1e-9);
  EXPECT_NEAR(other.lowest_frequency, one.lowest_frequency, 1e-9);
}

struct Recipe {
  Placement placement;
  bool rim;
};

class FlexibilityOf : public testing::TestWithParam<Recipe> {};

/// The estimate is on the safe side, and not by more than a factor of 8.
TEST_P(FlexibilityOf, RandomDisksIsEstimatedSafely) {
  for (const int points : {100, 150, 300}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const Lattice lattice =
          triangulated_lattice(place_in_disk({points, GetParam().placement, GetParam().rim}, seed));
      const Flexibility exact = computed_flexibility(lattice);
      const Flexibility estimate = estimated_flexibility(lattice);
      EXPECT_LT(exact.compliance, estimate.compliance) << points << " " << seed;
      EXPECT_GT(8.0 * exact.compliance, estimate.compliance) << points << " " << seed;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Recipes, FlexibilityOf,
                         testing::Values(Recipe{Placement::kBlueNoise, true},
                                         Recipe{Placement::kBlueNoise, false},
                                         Recipe{Placement::kUniform, true},
                                         Recipe{Placement::kUniform, false}));

/// The frequency of the lowest mode that is not rigid, from all eigenvalues; the mass is 1.
double lowest_frequency(const Lattice& lattice) {
  const auto entries = BondForces(lattice, {1.0, 0.0, 0.0}).stiffness(lattice.points);
  const Eigen::Index coordinates = 2 * lattice.points.rows();
  Eigen::SparseMatrix<double> stiffness(coordinates, coordinates);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(Eigen::MatrixXd(stiffness),
                                                             Eigen::EigenvaluesOnly);
  return std::sqrt(modes.eigenvalues()(3) * static_cast<double>(lattice.points.rows()));
}

TEST(Flexibility, HasAFrequencyBelowThatOfTheLowestMode) {
  for (const Placement placement : {Placement::kBlueNoise, Placement::kUniform}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Lattice lattice = triangulated_lattice(place_in_disk({150, placement, true}, seed));
      const double exact = lowest_frequency(lattice);
      EXPECT_LT(computed_flexibility(lattice).lowest_frequency, exact);
      EXPECT_LT(estimated_flexibility(lattice).lowest_frequency, exact);
      EXPECT_GT(2.0 * estimated_flexibility(lattice).lowest_frequency, exact);
    }
  }
}

TEST(Flexibility, OfWallsIsEstimatedSafely) {
  for (const double width : {1.0, 2.0, 3.0, 6.0}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      for (const Placement placement : {Placement::kBlueNoise, Placement::kUniform}) {
        const Lattice lattice =
            triangulated_lattice(place_in_rectangle({200, placement, true}, width, 1.0, seed));
        EXPECT_LT(computed_flexibility(lattice).compliance,
                  estimated_flexibility(lattice).compliance)
            << width << " " << seed;
      }
    }
  }
}

/// Points that are pulled out by a growing force, at every energy until the lattice is torn out of
/// the range in which the bound is used: what they do to first and second order.
TEST(Flexibility, BoundsHowFarAPointIsPulledOut) {
  const Lattice lattice = triangulated_lattice(place_in_disk({60}, 1));
  const double compliance = computed_flexibility(lattice).compliance;
  const double spacing = std::sqrt(M_PI / 60);
  BondForces bonds(lattice, {1.0, 0.0, 0.0});
  Eigen::Index lowest = 0;
  lattice.points.col(1).minCoeff(&lowest);
  PointArray position = lattice.points;
  PointArray force(60, 2);
  double greatest = 0.0;
  for (double pull = 0.01; pull < 0.2; pull += 0.01) {
    for (int k = 0; k < 4000; ++k) {
      bonds.evaluate_elastic(position, force);
      force.col(1) += pull / 60;
      force(lowest, 1) -= pull;
      position += 0.05 * force;
    }
    const double x = std::sqrt(2.0 * bonds.potential_energy(position));
    if (x > spacing / 3.0) break;
    const double out = position.col(1).mean() - position(lowest, 1) -
                       (lattice.points.col(1).mean() - lattice.points(lowest, 1));
    greatest = std::max(greatest, out / (std::sqrt(compliance) * x * (1.0 + x / spacing)));
  }
  EXPECT_LT(greatest, 1.0);
  EXPECT_GT(greatest, 0.5);
}

}  // namespace
}  // namespace impact
