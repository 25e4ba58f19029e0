#include "measure/elastic_constants.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cmath>
#include <vector>

#include "lattice/placement.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

constexpr double kTriangularModulus = 1.1547005383792515;  // 2/√3 in units of k_a

PointArray transformed(const PointArray& points, const Eigen::Matrix2d& deformation) {
  return (points.matrix() * deformation.transpose()).array();
}

Eigen::Matrix2d rotation(double angle) {
  return Eigen::Rotation2D<double>(angle).toRotationMatrix();
}

PeriodicPatch triangular_torus() {
  const int side = 12;
  PointArray points(side * side, 2);
  for (int i = 0; i < points.rows(); ++i) {
    const int row = i / side;
    points.row(i) << i % side + 0.5 * (row % 2), row * std::sqrt(0.75);
  }
  return triangulated_patch(points, side, side * std::sqrt(0.75));
}

TEST(PeriodicStiffness, OfTheTriangularLattice) {
  const Eigen::Matrix3d stiffness = periodic_stiffness(triangular_torus(), 1.0);
  const ElasticConstants constants = isotropic_average(stiffness);
  const double rounding = 1e-13;  // of a solution of 286 unknowns
  EXPECT_NEAR(constants.young_modulus, kTriangularModulus, rounding);
  EXPECT_NEAR(constants.poisson_ratio, 1.0 / 3.0, rounding);
  EXPECT_NEAR(anisotropy(stiffness), 0.0, rounding);
}

/// The points of a sheared triangular lattice, joined as before, are still a Bravais lattice, so
/// nothing relaxes and C_ijkl = k_a/area Σ n_i n_j n_k n_l d².
TEST(PeriodicStiffness, OfABravaisLatticeIsAffine) {
  PeriodicPatch patch = triangular_torus();
  const Eigen::Matrix2d stretch = Eigen::Vector2d(1.2, 0.9).asDiagonal();
  patch.bond_vectors = transformed(patch.bond_vectors, stretch);
  patch.width *= 1.2;
  patch.height *= 0.9;
  Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
  for (const double angle : {0.0, M_PI / 3.0, 2.0 * M_PI / 3.0}) {
    const Eigen::Vector2d d = stretch * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const Eigen::Vector3d dyad(d.x() * d.x(), d.y() * d.y(), d.x() * d.y());
    expected += 2.5 * dyad * dyad.transpose() / d.squaredNorm();
  }
  expected /= 1.2 * 0.9 * std::sqrt(0.75);  // area of a point, which has three bonds
  const Eigen::Matrix3d stiffness = periodic_stiffness(patch, 2.5);
  EXPECT_NEAR((stiffness - expected).norm(), 0.0, 1e-12);
  EXPECT_GT(anisotropy(stiffness), 0.1);
}

/// A network whose points stay at their affine places has C₁₁ + C₂₂ + 2 C₁₂ = k_a/area Σ d²; one
/// that relaxes is softer.
TEST(PeriodicStiffness, RelaxesARandomLattice) {
  const PeriodicPatch patch = random_patch(400, Placement::kBlueNoise, 1.0, 1.0, 3);
  const Eigen::Matrix3d stiffness = periodic_stiffness(patch, 1.0);
  const double asymmetry = (stiffness - stiffness.transpose()).norm();
  EXPECT_NEAR(asymmetry, 0.0, 1e-12);  // rounding of a sum of 1200 terms
  const double affine = patch.bond_vectors.square().sum();
  EXPECT_LT(stiffness.topLeftCorner(2, 2).sum(), 0.999 * affine);
  EXPECT_GT(stiffness.topLeftCorner(2, 2).sum(), 0.5 * affine);
}

/// Linear springs: C is proportional to k_a and does not know the unit of length.
TEST(PeriodicStiffness, ScalesWithTheSprings) {
  const Eigen::Matrix3d one =
      periodic_stiffness(random_patch(200, Placement::kUniform, 1.0, 1.0, 3), 1.0);
  const Eigen::Matrix3d other =
      periodic_stiffness(random_patch(200, Placement::kUniform, 4.0, 4.0, 3), 7.0);
  EXPECT_NEAR((other / 7.0 - one).norm(), 0.0,
              1e-10);  // rounding times the condition of the springs
}

TEST(IsotropicAverage, IsTheSameInAnyFrame) {
  Eigen::Matrix3d stiffness;
  stiffness << 3.0, 0.5, 0.0, 0.5, 2.0, 0.0, 0.0, 0.0, 0.7;
  Eigen::Matrix3d turned;  // by 45°
  turned << 2.2, 0.8, 0.25, 0.8, 2.2, 0.25, 0.25, 0.25, 1.0;
  EXPECT_NEAR(isotropic_average(turned).young_modulus, isotropic_average(stiffness).young_modulus,
              1e-14);
  EXPECT_NEAR(isotropic_average(turned).poisson_ratio, isotropic_average(stiffness).poisson_ratio,
              1e-14);
  EXPECT_NEAR(anisotropy(turned), anisotropy(stiffness), 1e-14);
}

struct Expected {
  Placement placement;
  ElasticConstants constants;
  ElasticConstants uncertainty;
};

/// The known values, in units of k_a, are an independent program's, with its uncertainty: the mean
/// lies within two standard errors of both.
void expect_mean(const std::vector<ElasticConstants>& found, const Expected& expected) {
  const auto n = static_cast<Eigen::Index>(found.size());
  Eigen::ArrayX2d values(n, 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    const ElasticConstants& one = found[static_cast<std::size_t>(i)];
    values.row(i) << one.young_modulus, one.poisson_ratio;
  }
  const Eigen::Array<double, 1, 2> mean = values.colwise().mean();
  const Eigen::Array<double, 1, 2> variance =
      (values.rowwise() - mean).square().colwise().sum() / static_cast<double>(n * (n - 1));
  const auto& [placement, known, uncertainty] = expected;
  EXPECT_NEAR(mean(0), known.young_modulus,
              2.0 * std::hypot(std::sqrt(variance(0)), uncertainty.young_modulus));
  EXPECT_NEAR(mean(1), known.poisson_ratio,
              2.0 * std::hypot(std::sqrt(variance(1)), uncertainty.poisson_ratio));
}

class RandomLattice : public testing::TestWithParam<Expected> {};

TEST_P(RandomLattice, HasTheKnownConstantsAsAnEndlessPatch) {
  std::vector<ElasticConstants> found;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const PeriodicPatch patch = random_patch(1500, GetParam().placement, 1.0, 1.0, seed);
    found.push_back(isotropic_average(periodic_stiffness(patch, 1.0)));
  }
  expect_mean(found, GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    ElasticConstants, RandomLattice,
    testing::Values(Expected{Placement::kBlueNoise, {1.085, 0.275}, {0.002, 0.002}},
                    Expected{Placement::kUniform, {1.04, 0.265}, {0.01, 0.004}}));

constexpr double kStrain = 1e-6;
constexpr double kStrainOrder = 10.0 * kStrain;  // relative error of linear elasticity

/// Whole periods of triangular_patch(20): 12 along x and 6 (of two rows) along y, with its ends
/// between the points.
const MiddleRegion kWholePeriods{6.0, 6.0 * std::sqrt(0.75)};

/// An affine strain is in equilibrium in a triangular lattice. With ε_yy = −ε_xx/3 no force acts on
/// the sides, otherwise σ_yy ≠ 0.
TEST(StretchedConstants, OfTheTriangularLattice) {
  const Lattice lattice = triangular_patch(20);
  const BondLaw law{2.0, 1e-3, 0.0};
  for (const double lateral : {-1.0 / 3.0, 0.0, 0.5}) {
    for (const double angle : {0.0, 1e-3, 1.0}) {
      const Eigen::Matrix2d strain = Eigen::Vector2d(kStrain, lateral * kStrain).asDiagonal();
      PointArray position =
          transformed(lattice.points, rotation(angle) * (Eigen::Matrix2d::Identity() + strain));
      position.col(0) += 3.0;
      const ElasticConstants constants = stretched_constants(lattice, position, law, kWholePeriods);
      EXPECT_NEAR(constants.young_modulus, 2.0 * kTriangularModulus, kStrainOrder);
      EXPECT_NEAR(constants.poisson_ratio, 1.0 / 3.0, kStrainOrder);
    }
  }
}

TEST(MeanStress, VanishesInTheReferenceLattice) {
  const Lattice lattice = triangular_patch(8);
  EXPECT_EQ(mean_stress(lattice, lattice.points, {}, {2.0, 2.0}), Eigen::Matrix2d::Zero());
}

/// Two points 1 apart on the x axis, pulled to 1.1: tension times the length inside over the area.
TEST(MeanStress, WeighsABondByItsLengthInside) {
  const Lattice lattice = two_points();
  PointArray position = lattice.points;
  position(1, 0) = 1.1;
  const double tension = 0.1 + 0.5 * 0.001;
  const BondLaw law{1.0, 0.5, 0.0};
  Eigen::Matrix2d expected = Eigen::Matrix2d::Zero();
  expected(0, 0) = tension * 0.5 / (0.5 * 2.0);  // half of the bond lies in 0.5 R by 2 R
  EXPECT_TRUE(mean_stress(lattice, position, law, {0.25, 1.0}).isApprox(expected, 1e-14));
  expected(0, 0) = tension / (3.0 * 2.0);  // all of it
  EXPECT_TRUE(mean_stress(lattice, position, law, {1.5, 1.0}).isApprox(expected, 1e-14));
}

constexpr double kWidth = 4.0;
constexpr double kHeight = 2.0;

/// The rectangle with its left and right columns held at ±kStrain kWidth/2 along x and at no
/// displacement along y, in equilibrium (one step of Newton's method).
PointArray stretched(const Lattice& lattice, const BondLaw& law) {
  const Eigen::Index n = lattice.points.rows();
  Eigen::SparseMatrix<double> stiffness(2 * n, 2 * n);
  const auto entries = BondForces(lattice, law).stiffness(lattice.points);
  stiffness.setFromTriplets(entries.begin(), entries.end());

  Eigen::VectorXd displacement = Eigen::VectorXd::Zero(2 * n);
  displacement.head(n) = kStrain * lattice.points.col(0);
  const Eigen::VectorXd force = -stiffness * displacement;
  Eigen::VectorXd free = Eigen::VectorXd::Ones(2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (std::abs(lattice.points(i, 0)) == kWidth / 2.0) free(i) = free(n + i) = 0.0;
  }
  const Eigen::VectorXd held = Eigen::VectorXd::Ones(2 * n) - free;
  Eigen::SparseMatrix<double> reduced = free.asDiagonal() * stiffness * free.asDiagonal();
  reduced += Eigen::SparseMatrix<double>(held.asDiagonal());
  displacement +=
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(reduced).solve(free.cwiseProduct(force));
  return lattice.points + displacement.reshaped(n, 2).array();
}

Lattice random_rectangle(const PlacementRecipe& recipe, std::uint64_t seed) {
  return triangulated_lattice(place_in_rectangle(recipe, kWidth, kHeight, seed));
}

/// With free sides, the pull on the ends passes through every cross-section.
TEST(MeanStress, OverTheWholeHeightIsThePull) {
  const BondLaw law;
  const Lattice lattice = random_rectangle({500, Placement::kBlueNoise, true}, 1);
  const PointArray position = stretched(lattice, law);
  PointArray force = PointArray::Zero(position.rows(), 2);
  BondForces(lattice, law).evaluate(position, position, force);
  const auto on_end = lattice.points.col(0) == kWidth / 2.0;
  const Eigen::Vector2d pull(-on_end.select(force.col(0), 0.0).sum(),
                             -on_end.select(force.col(1), 0.0).sum());

  for (const double half_width : {0.01, 0.5, 1.7, kWidth / 2.0}) {
    const Eigen::Matrix2d stress = mean_stress(lattice, position, law, {half_width, kHeight / 2.0});
    EXPECT_LT((kHeight * stress.col(0) - pull).norm(), kStrainOrder * pull.norm());
  }
}

/// Away from the sides, where the rim makes the lattice stiffer.
TEST_P(RandomLattice, HasTheKnownConstantsInTheMiddleOfAStretchedBody) {
  std::vector<ElasticConstants> found;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Lattice lattice = random_rectangle({1099, GetParam().placement, true}, seed);
    found.push_back(stretched_constants(lattice, stretched(lattice, {}), {}, {1.0, 0.8}));
  }
  expect_mean(found, GetParam());
}

TEST(StretchedConstants, AreNotKnownWithoutPoints) {
  const Lattice lattice = triangular_patch(8);
  EXPECT_TRUE(
      std::isnan(stretched_constants(lattice, lattice.points, {}, {0.1, 0.1}).young_modulus));
}

}  // namespace
}  // namespace impact
