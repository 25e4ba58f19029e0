#include "mechanics/bond_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "every_kernel.hpp"
#include "test_lattices.hpp"

namespace impact {
namespace {

PointArray forces(BondForces& bonds, const PointArray& position, const PointArray& velocity) {
  PointArray force = PointArray::Zero(position.rows(), 2);
  bonds.evaluate(position, velocity, force);
  return force;
}

PointArray random_points(Eigen::Index count, unsigned seed) {
  std::srand(seed);
  return PointArray::Random(count, 2);
}

/// Eq. (1) by hand: elongation 0.5, f = k_a x + k_b x³ towards the other point.
TEST(BondForces, OfOneStretchedBond) {
  BondForces bonds(two_points(), {2.0, 3.0, 0.0});
  PointArray position(2, 2);
  position << 0, 0, 0, 1.5;
  const PointArray force = forces(bonds, position, PointArray::Zero(2, 2));
  const double tension = 2.0 * 0.5 + 3.0 * 0.125;
  EXPECT_DOUBLE_EQ(force(0, 1), tension);
  EXPECT_DOUBLE_EQ(force(1, 1), -tension);
  EXPECT_EQ(force(0, 0), 0.0);
  EXPECT_DOUBLE_EQ(bonds.potential_energy(position), 2.0 * 0.25 / 2 + 3.0 * 0.0625 / 4);
}

/// The damping is the whole relative velocity, also across the bond.
TEST(BondForces, DampingResistsTheWholeRelativeVelocity) {
  BondForces bonds(two_points(), {1.0, 0.0, 0.5});
  PointArray velocity(2, 2);
  velocity << 1, 2, 0, -1;
  PointArray force = PointArray::Zero(2, 2);
  const double power = bonds.evaluate(two_points().points, velocity, force);
  EXPECT_DOUBLE_EQ(force(0, 0), -0.5 * 1.0);
  EXPECT_DOUBLE_EQ(force(0, 1), -0.5 * 3.0);
  EXPECT_DOUBLE_EQ(force(1, 0), 0.5 * 1.0);
  EXPECT_DOUBLE_EQ(force(1, 1), 0.5 * 3.0);
  EXPECT_DOUBLE_EQ(power, 0.5 * (1.0 + 9.0));
}

class EveryLaw : public testing::TestWithParam<BondLaw> {};

TEST_P(EveryLaw, ConservesLinearMomentum) {
  const Lattice lattice = triangular_patch(6);
  BondForces bonds(lattice, GetParam());
  const PointArray position = lattice.points + 0.1 * random_points(36, 1);
  const PointArray force = forces(bonds, position, random_points(36, 2));
  // 36 forces of order 10 add up with rounding errors of 10⁻¹⁶ each.
  EXPECT_NEAR(force.col(0).sum(), 0.0, 1e-12);
  EXPECT_NEAR(force.col(1).sum(), 0.0, 1e-12);
}

TEST_P(EveryLaw, ForceIsMinusTheGradientOfTheEnergy) {
  const Lattice lattice = triangular_patch(4);
  BondForces bonds(lattice, GetParam());
  const PointArray position = lattice.points + 0.1 * random_points(16, 1);
  const PointArray force = forces(bonds, position, PointArray::Zero(16, 2));
  constexpr double kStep = 1e-6;
  for (Eigen::Index i = 0; i < force.size(); ++i) {
    PointArray above = position;
    PointArray below = position;
    above.data()[i] += kStep;
    below.data()[i] -= kStep;
    const double slope =
        (bonds.potential_energy(above) - bonds.potential_energy(below)) / (2.0 * kStep);
    // Central differences: truncation of order step² and rounding of order 10⁻¹⁵/step.
    EXPECT_NEAR(force.data()[i], -slope, 1e-8);
  }
}

TEST_P(EveryLaw, TorqueVanishesWithoutDampingOnly) {
  const Lattice lattice = triangular_patch(4);
  BondForces bonds(lattice, GetParam());
  PointArray velocity(16, 2);  // a rigid rotation
  velocity.col(0) = -lattice.points.col(1);
  velocity.col(1) = lattice.points.col(0);
  const PointArray force = forces(bonds, lattice.points, velocity);
  const double torque =
      (lattice.points.col(0) * force.col(1) - lattice.points.col(1) * force.col(0)).sum();
  // Rotation at rate 1 has relative velocity l ẑ × n across each bond: torque −η Σ l².
  double expected = 0.0;
  for (const double length : lattice.natural_lengths) expected -= GetParam().eta * length * length;
  EXPECT_NEAR(torque, expected, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw,
                         testing::Values(BondLaw{1.0, 0.0, 0.0}, BondLaw{1.0, 5.0, 0.0},
                                         BondLaw{2.0, 0.0, 0.7}, BondLaw{2.0, 5.0, 0.7}));

struct ForcesAndPower {
  PointArray force;
  double power = 0.0;
};

/// Eq. (1), bond by bond, as it stands.
ForcesAndPower reference(const Lattice& lattice, const BondLaw& law, const PointArray& position,
                         const PointArray& velocity) {
  ForcesAndPower sum{PointArray::Zero(position.rows(), 2)};
  for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
    const auto [i, j] = lattice.bonds[k];
    const Eigen::Vector2d r = (position.row(i) - position.row(j)).matrix().transpose();
    const Eigen::Array2d v = (velocity.row(i) - velocity.row(j)).transpose();
    const double x = r.norm() - lattice.natural_lengths[k];
    const Eigen::Array2d f =
        -(law.k_a * x + law.k_b * x * x * x) * r.normalized().array() - law.eta * v;
    sum.force.row(i) += f.transpose();
    sum.force.row(j) -= f.transpose();
    sum.power += law.eta * v.square().sum();
  }
  return sum;
}

class EveryKernel : public KernelTest {};

/// With a number of points that fills no whole slice, and points with two to six bonds.
TEST_P(EveryKernel, GivesTheForcesAndThePower) {
  const Lattice lattice = triangular_patch(7);
  const PointArray position = lattice.points + 0.2 * random_points(49, 1);
  const PointArray velocity = random_points(49, 2);
  for (const BondLaw& law : {BondLaw{1.0, 0.0, 0.0}, BondLaw{1.0, 5.0, 0.0}, BondLaw{2.0, 0.0, 0.7},
                             BondLaw{2.0, 5.0, 0.7}}) {
    const ForcesAndPower expected = reference(lattice, law, position, velocity);
    BondForces bonds(lattice, law, *GetParam());
    PointArray force = PointArray::Constant(49, 2, std::nan(""));
    const double power = bonds.evaluate(position, velocity, force);
    // The sums have six terms each, and 10⁻¹⁶ is the rounding of one; a wrong estimate of the root
    // would be off by 10⁻⁹ or more.
    const double rounding = 1e-14 * expected.force.abs().maxCoeff();
    EXPECT_LT((force - expected.force).abs().maxCoeff(), rounding);
    EXPECT_NEAR(power, expected.power, 1e-13 * expected.power);

    EXPECT_EQ(bonds.evaluate_damping(velocity, force), power);
    const BondLaw damping{0.0, 0.0, law.eta};
    EXPECT_LT((force - reference(lattice, damping, position, velocity).force).abs().maxCoeff(),
              rounding);

    const BondLaw undamped{law.k_a, law.k_b, 0.0};
    bonds.evaluate_elastic(position, force);
    EXPECT_LT((force - reference(lattice, undamped, position, velocity).force).abs().maxCoeff(),
              rounding);
  }
}

/// Two bodies in one lattice.
Lattice side_by_side(const Lattice& first, const Lattice& second) {
  Lattice both = first;
  const Eigen::Index rows = first.points.rows();
  both.points.conservativeResize(rows + second.points.rows(), 2);
  both.points.bottomRows(second.points.rows()) = second.points;
  for (const Bond& bond : second.bonds) {
    both.bonds.push_back({bond.first + static_cast<std::int32_t>(rows),
                          bond.second + static_cast<std::int32_t>(rows)});
  }
  both.natural_lengths.insert(both.natural_lengths.end(), second.natural_lengths.begin(),
                              second.natural_lengths.end());
  return both;
}

double energy_by_bonds(const Lattice& lattice, const BondLaw& law, const PointArray& position) {
  double energy = 0.0;
  for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
    const Bond& bond = lattice.bonds[k];
    const double length = (position.row(bond.first) - position.row(bond.second)).matrix().norm();
    const double x = length - lattice.natural_lengths[k];
    energy += law.k_a * x * x / 2.0 + law.k_b * x * x * x * x / 4.0;
  }
  return energy;
}

/// 9, 2 and 49 points: bodies meet within a slice, one lies in a slice with others, and none fills
/// its last one.
TEST_P(EveryKernel, GivesTheEnergyOfEachBody) {
  const std::vector<Lattice> bodies{triangular_patch(3), two_points(), triangular_patch(7)};
  const Lattice all = side_by_side(side_by_side(bodies[0], bodies[1]), bodies[2]);
  const BondLaw law{2.0, 5.0, 0.0};
  const PointArray position = all.points + 0.2 * random_points(60, 1);
  const BondForces bonds(all, law, *GetParam());
  constexpr double kRounding = 1e-14;  // of sums of some hundred terms of one sign
  Eigen::Index first = 0;
  double sum = 0.0;
  for (const Lattice& body : bodies) {
    const Eigen::Index points = body.points.rows();
    const double energy = energy_by_bonds(body, law, position.middleRows(first, points));
    EXPECT_NEAR(bonds.potential_energy(position, first, first + points) / energy, 1.0, kRounding);
    first += points;
    sum += energy;
  }
  EXPECT_NEAR(bonds.potential_energy(position) / sum, 1.0, kRounding);
}

TEST_P(EveryKernel, KicksAndDrifts) {
  const PointArray f = random_points(7, 1);
  PointArray v = random_points(7, 2);
  PointArray x = random_points(7, 3);
  const PointArray kicked = v + 0.3 * f;
  const PointArray twice = kicked + 0.3 * f;
  const PointArray drifted = x + 0.2 * twice;
  constexpr double kRounding = 5e-16;
  GetParam()->kick(0.3, f.data(), v.data(), v.size());
  EXPECT_LT((v - kicked).abs().maxCoeff(), kRounding);
  GetParam()->kick_and_drift(0.3, f.data(), 0.2, v.data(), x.data(), x.size());
  EXPECT_LT((v - twice).abs().maxCoeff(), kRounding);
  EXPECT_LT((x - drifted).abs().maxCoeff(), kRounding);
}

/// A disk that blew up must not look at rest.
TEST_P(EveryKernel, PassesOnWhatIsNotFinite) {
  BondForces bonds(two_points(), {1.0, 0.0, 0.0}, *GetParam());
  for (const double lost : {std::nan(""), std::numeric_limits<double>::infinity(), 1e200}) {
    PointArray position = two_points().points;
    position(1, 0) = lost;
    PointArray force(2, 2);
    bonds.evaluate_elastic(position, force);
    EXPECT_FALSE(force.allFinite()) << lost;
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, EveryKernel, all_kernels(), kernel_name);

TEST(BondForces, NameTellsWhatIsEvaluated) {
  const auto name = [](const BondLaw& law) { return BondForces(triangle(), law).name(); };
  EXPECT_EQ(name({1.0, 0.0, 0.0}), "bonds");
  EXPECT_EQ(name({1.0, 1.0, 0.0}), "bonds (cubic)");
  EXPECT_EQ(name({1.0, 0.0, 1.0}), "bonds (damped)");
  EXPECT_EQ(name({1.0, 1.0, 1.0}), "bonds (cubic, damped)");
}

/// A law without damping does not read velocities at all.
TEST(BondForces, WithoutDampingVelocitiesAreNotRead) {
  BondForces bonds(two_points(), {1.0, 0.0, 0.0});
  const PointArray nonsense = PointArray::Constant(2, 2, std::nan(""));
  EXPECT_TRUE((forces(bonds, two_points().points, nonsense) == 0.0).all());
}

/// Energy of the middle of a triangular lattice per area under the strain (xx, yy), in units of
/// k_a: each of the three bonds of a point has energy k_a (n·ε·n)²/2.
double energy_density(double xx, double yy) {
  const Lattice lattice = triangular_patch(3);
  PointArray strained = lattice.points;
  strained.col(0) *= 1.0 + xx;
  strained.col(1) *= 1.0 + yy;
  const int middle = 4;
  Lattice star{lattice.points, {}, {}};
  for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
    if (lattice.bonds[k].first != middle && lattice.bonds[k].second != middle) continue;
    star.bonds.push_back(lattice.bonds[k]);
    star.natural_lengths.push_back(lattice.natural_lengths[k]);
  }
  EXPECT_EQ(star.bonds.size(), 6U);
  const double area = std::sqrt(0.75);
  return 0.5 * BondForces(star, {1.0, 0.0, 0.0}).potential_energy(strained) / area;
}

/// E = 2/√3 k_a and ν = 1/3, from the energy of homogeneous strains.
TEST(BondForces, TriangularLatticeHasItsElasticConstants) {
  constexpr double kStrain = 1e-5;
  const double c_11 = 2.0 * energy_density(kStrain, 0.0) / (kStrain * kStrain);
  const double both = 2.0 * energy_density(kStrain, kStrain) / (kStrain * kStrain);
  const double c_12 = both / 2.0 - c_11;
  // The energy is quadratic up to terms of relative order of the strain.
  EXPECT_NEAR(c_12 / c_11, 1.0 / 3.0, 10.0 * kStrain);
  EXPECT_NEAR(c_11 - c_12 * c_12 / c_11, 2.0 / std::sqrt(3.0), 10.0 * kStrain);
}

/// One order for all copies, whatever their law; but that of two bodies has the points of both.
TEST(BondForces, ShareTheOrderInWhichTheyAreEliminated) {
  const BondForces bonds(triangular_patch(4), {1.0, 0.0, 0.0});
  const BondForces damped = bonds.with({1.0, 0.0, 2.0});
  EXPECT_EQ(&damped.elimination_order(), &bonds.elimination_order());
  EXPECT_EQ(bonds.elimination_order().size(), 16);
  const BondForces both = BondForces::of_two_laws(bonds, damped);
  EXPECT_EQ(both.elimination_order().size(), 32);
  EXPECT_EQ(bonds.elimination_order().size(), 16);
}

/// Two triangles beside each other: the forces, powers, energies and matrices of two bodies with
/// two laws are those of each by itself.
TEST(BondForces, OfTwoBodiesAreThoseOfEach) {
  Lattice other = triangular_patch(3);
  other.points.col(0) += 10.0;
  const Lattice disk = triangular_patch(4);
  const BondLaw soft{0.01, 0.3, 0.7};
  const BondLaw hard{1.0, 0.5, 0.0};
  BondForces of_disk(disk, hard);
  BondForces of_other(other, soft);
  BondForces both = BondForces::of_two_laws(of_disk, of_other);
  ASSERT_EQ(both.points(), 25);
  EXPECT_TRUE(both.has_two_laws());
  EXPECT_TRUE(both.damped());

  PointArray position(25, 2);
  position << disk.points, other.points;
  PointArray velocity = PointArray::Zero(25, 2);
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, 0.01);
  for (Eigen::Index i = 0; i < 25; ++i) {
    for (const int axis : {0, 1}) {
      position(i, axis) += noise(random);
      velocity(i, axis) = noise(random);
    }
  }
  PointArray force(25, 2);
  PointArray disk_force(16, 2);
  PointArray other_force(9, 2);
  const PointArray disk_position = position.topRows(16);
  const PointArray other_position = position.bottomRows(9);
  const double power = both.evaluate(position, velocity, force);
  of_disk.evaluate(disk_position, velocity.topRows(16), disk_force);
  EXPECT_EQ(power, of_other.evaluate(other_position, velocity.bottomRows(9), other_force));
  EXPECT_TRUE((force.topRows(16) == disk_force).all());
  EXPECT_TRUE((force.bottomRows(9) == other_force).all());
  EXPECT_EQ(both.potential_energy(position, 16, 25), of_other.potential_energy(other_position));
  EXPECT_EQ(both.potential_energy(position, 0, 16), of_disk.potential_energy(disk_position));
  EXPECT_DOUBLE_EQ(both.potential_energy(position), of_disk.potential_energy(disk_position) +
                                                        of_other.potential_energy(other_position));

  EXPECT_EQ(both.evaluate_damping(velocity, force), power);
  of_other.evaluate_damping(velocity.bottomRows(9), other_force);
  EXPECT_TRUE((force.topRows(16) == 0.0).all());
  EXPECT_TRUE((force.bottomRows(9) == other_force).all());
  both.evaluate_elastic(position, force);
  of_other.evaluate_elastic(other_position, other_force);
  EXPECT_TRUE((force.bottomRows(9) == other_force).all());

  const auto dense = [](const std::vector<Eigen::Triplet<double>>& entries, Eigen::Index size) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    for (const auto& entry : entries) matrix(entry.row(), entry.col()) += entry.value();
    return matrix;
  };
  const Eigen::MatrixXd damping = dense(both.damping(), 25);
  EXPECT_EQ(damping.bottomRightCorner(9, 9), dense(of_other.damping(), 9));
  EXPECT_TRUE(damping.topRows(16).isZero(0.0));
  // −∂F/∂r by a shift of one point of the second body, whose x is coordinate 16 and y 25 + 16.
  const Eigen::MatrixXd stiffness = dense(both.stiffness(position), 50);
  constexpr double kStep = 1e-6;
  for (const int axis : {0, 1}) {
    PointArray above = position;
    PointArray below = position;
    above(16, axis) += kStep;
    below(16, axis) -= kStep;
    PointArray force_above(25, 2);
    PointArray force_below(25, 2);
    both.evaluate_elastic(above, force_above);
    both.evaluate_elastic(below, force_below);
    const PointArray slope = (force_below - force_above) / (2.0 * kStep);
    const Eigen::VectorXd column = stiffness.col(axis * 25 + 16);
    // Truncation k_b h² and rounding 10⁻¹⁶/h of forces of order 0.01.
    EXPECT_LT((Eigen::Map<const Eigen::VectorXd>(slope.data(), 50) - column).cwiseAbs().maxCoeff(),
              1e-9);
  }
}

}  // namespace
}  // namespace impact
