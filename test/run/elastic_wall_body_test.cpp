#include "run/elastic_wall_body.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "expect_input_error.hpp"
#include "lattice/lammps_writing.hpp"
#include "mechanics/simulation.hpp"

namespace impact {
namespace {

Scene wall_scene() {
  Scene scene;
  scene.wall.kind = WallKind::kLattice;
  return scene;
}

double width(const Lattice& lattice) {
  return lattice.points.col(0).maxCoeff() - lattice.points.col(0).minCoeff();
}
double height(const Lattice& lattice) {
  return lattice.points.col(1).maxCoeff() - lattice.points.col(1).minCoeff();
}

TEST(ElasticWallBody, HasTheDensityOfTheDiskUnlessToldOtherwise) {
  Scene scene = wall_scene();
  const double area = 1269 * M_PI / 1099;
  const Lattice automatic = elastic_wall_body(scene, 1099).lattice;
  EXPECT_EQ(automatic.points.rows(), 1269);
  EXPECT_NEAR(width(automatic) / height(automatic), 2.0, 1e-12);
  EXPECT_NEAR(width(automatic) * height(automatic), area, 1e-12);
  scene.wall.width = 3.0;
  EXPECT_NEAR(width(elastic_wall_body(scene, 1099).lattice), 3.0, 1e-12);
  EXPECT_NEAR(height(elastic_wall_body(scene, 1099).lattice), area / 3.0, 1e-12);
  scene.wall.height = 1.0;
  EXPECT_NEAR(height(elastic_wall_body(scene, 1099).lattice), 1.0, 1e-12);
  scene.wall.width.reset();
  EXPECT_NEAR(width(elastic_wall_body(scene, 1099).lattice), area, 1e-12);
}

TEST(ElasticWallBody, LiesBelowTheOrigin) {
  const PlacedBody wall = elastic_wall_body(wall_scene(), 1099);
  for (const std::int32_t point : wall.sides.top) EXPECT_EQ(wall.lattice.points(point, 1), 0.0);
  EXPECT_NEAR(wall.lattice.points.col(0).maxCoeff() + wall.lattice.points.col(0).minCoeff(), 0.0,
              1e-15);
  EXPECT_LE(wall.lattice.points.col(1).maxCoeff(), 0.0);
}

/// The same every time; another one for another seed, and not the disk's numbers again.
TEST(ElasticWallBody, DependsOnTheSeedAlone) {
  Scene scene = wall_scene();
  const PointArray points = elastic_wall_body(scene, 1099).lattice.points;
  EXPECT_TRUE((points == elastic_wall_body(scene, 1099).lattice.points).all());
  scene.seed = 2;
  EXPECT_FALSE((points == elastic_wall_body(scene, 1099).lattice.points).all());
}

TEST(ElasticWallBody, ComesFromAFile) {
  const std::string path = testing::TempDir() + "elastic_wall_body_test.data";
  const PlacedBody wall = elastic_wall_body(wall_scene(), 1099);
  Lattice elsewhere = wall.lattice;
  elsewhere.points.col(0) += 5.0;
  elsewhere.points.col(1) -= 3.0;
  write_lammps_data(elsewhere, 1.0 / 1099, path);
  Scene scene = wall_scene();
  scene.wall.file = path;
  const PlacedBody again = elastic_wall_body(scene, 1099);
  // Rounding of the shifts.
  EXPECT_LT((again.lattice.points - wall.lattice.points).abs().maxCoeff(), 1e-14);
  EXPECT_EQ(again.sides.top, wall.sides.top);
  EXPECT_EQ(again.sides.bottom, wall.sides.bottom);
}

TEST(ElasticWallBody, SaysWhatCannotBeUsed) {
  Scene scene = wall_scene();
  scene.wall.points = 3;
  EXPECT_INPUT_ERROR(elastic_wall_body(scene, 1099), "wall.points: ");
  scene.wall.file = "/nowhere/wall.data";
  EXPECT_INPUT_ERROR(elastic_wall_body(scene, 1099), "wall.file: /nowhere/wall.data");
  PointArray triangle(3, 2);
  triangle << 0, 0, 2, 0, 1, 1;
  scene.wall.file = testing::TempDir() + "triangle.data";
  write_lammps_data(make_lattice(triangle, {{0, 1}, {0, 2}, {1, 2}}), 1.0, scene.wall.file);
  EXPECT_INPUT_ERROR(elastic_wall_body(scene, 1099),
                     "wall.file: the top side has fewer than two points");
}

/// The dashpots of the three sides add up to ρ c times their lengths.
TEST(ViscousBoundary, CoversTheSides) {
  const PlacedBody wall = elastic_wall_body(wall_scene(), 1099);
  const double mass = 1.0 / 1099;
  ViscousBoundary boundary = viscous_boundary(wall, mass, 2.0, 0);
  const double w = width(wall.lattice);
  const double h = height(wall.lattice);
  const double density = 1.0 / M_PI;
  const double across = std::sqrt(density * 1.2990381056766580 * 2.0);
  const double along = std::sqrt(density * 0.4330127018922193 * 2.0);
  PointArray force = PointArray::Zero(1269, 2);
  boundary.add_damping_forces(PointArray::Ones(1269, 2), force);
  // Two sides of length h and one of length w.
  EXPECT_NEAR(force.col(0).sum(), -(2.0 * h * across + w * along), 1e-12);
  EXPECT_NEAR(force.col(1).sum(), -(2.0 * h * along + w * across), 1e-12);
}

/// What became of a pulse that went down a wall to its bottom and came back.
struct Reflection {
  double left;      ///< of the energy, in the whole wall
  double returned;  ///< of the energy, within four pulse widths of the top
};

/// A pulse that runs down a wall of unit k_a. Its left and right sides slide: they hold what a
/// plane wave with displacements along `axis` (0: x, 1: y) does not move there, and let it pass.
struct Pulse {
  const PlacedBody& wall;
  double point_mass;
  int axis;
  double modulus;  ///< ρ c² of the wave
  double width;

  /// Half a Gaussian from the top, as a velocity: the wave goes down whole, and a wave that comes
  /// back rises to the same at the free top.
  State start() const {
    State state;
    state.position = wall.lattice.points;
    state.velocity = PointArray::Zero(state.position.rows(), 2);
    state.velocity.col(axis) = 1e-5 * (-(state.position.col(1) / width).square() / 2.0).exp();
    return state;
  }

  ForceField field() const {
    ForceField field{BondForces(wall.lattice, {1.0, 0.0, 0.0}), point_mass};
    field.supports.emplace(held(0), held(1));
    return field;
  }

  Reflection after(ForceField field, double step) const {
    const double density = point_mass * static_cast<double>(wall.lattice.points.rows()) /
                           (impact::width(wall.lattice) * height(wall.lattice));
    const double time = 2.0 * height(wall.lattice) / std::sqrt(modulus / density);
    Simulation simulation(std::move(field), start(), {}, step);
    const double energy = energy_above(simulation.state(), -1e9);
    while (simulation.state().time < time) simulation.step();
    return {energy_above(simulation.state(), -1e9) / energy,
            energy_above(simulation.state(), -4.0 * width) / energy};
  }

  Reflection from(Boundary boundary, double step, double interval = 0.0) const {
    ForceField channel = field();
    const auto& bottom = wall.sides.bottom;
    if (boundary == Boundary::kReset) channel.velocity_reset.emplace(bottom, interval);
    if (boundary == Boundary::kViscous) {
      const PlacedBody only_bottom{wall.lattice, {{}, {}, bottom, wall.sides.top}};
      channel.viscous_boundary = viscous_boundary(only_bottom, point_mass, 1.0, 0);
    }
    if (boundary == Boundary::kFixed) {
      auto x = held(0);
      auto y = held(1);
      x.insert(x.end(), bottom.begin(), bottom.end());
      y.insert(y.end(), bottom.begin(), bottom.end());
      channel.supports.emplace(x, y);
    }
    return after(std::move(channel), step);
  }

 private:
  std::vector<std::int32_t> held(int along) const {
    if (along == axis) return {};
    std::vector<std::int32_t> sides = wall.sides.left;
    sides.insert(sides.end(), wall.sides.right.begin(), wall.sides.right.end());
    return sides;
  }

  /// Of points, and of bonds by their first point.
  double energy_above(const State& state, double depth) const {
    const Lattice& lattice = wall.lattice;
    const auto is_above = (lattice.points.col(1) > depth).cast<double>();
    double energy = 0.5 * point_mass * (state.velocity.square().rowwise().sum() * is_above).sum();
    for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
      const auto [i, j] = lattice.bonds[k];
      if (lattice.points(i, 1) <= depth) continue;
      const double length = (state.position.row(i) - state.position.row(j)).matrix().norm();
      energy += 0.5 * std::pow(length - lattice.natural_lengths[k], 2);
    }
    return energy;
  }
};

/// The triangular lattice with bonds of length 1, its rows along x, from y = 0 down; its sides are
/// the ends of the rows.
PlacedBody triangular_wall(int columns, int rows) {
  PointArray points(columns * rows, 2);
  std::vector<Bond> bonds;
  RectangleSides sides;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int i = row * columns + column;
      points.row(i) << column + 0.5 * (row % 2), -row * std::sqrt(0.75);
      if (row == 0) sides.top.push_back(i);
      if (row + 1 == rows) sides.bottom.push_back(i);
      if (column == 0) sides.left.push_back(i);
      if (column + 1 == columns) sides.right.push_back(i);
      if (column + 1 < columns) bonds.push_back({i, i + 1});
      if (row + 1 == rows) continue;
      bonds.push_back({i, i + columns});
      const int other = column + (row % 2 == 0 ? -1 : 1);
      if (other >= 0 && other < columns) bonds.push_back({i, (row + 1) * columns + other});
    }
  }
  return {make_lattice(points, bonds), sides};
}

/// Modulus ρ c² of waves along y with displacements along x and y.
constexpr double kOfTriangularLattice[] = {0.4330, 1.2990};
/// With E = 1.082 k_a and ν = 0.276 of blue-noise lattices.
constexpr double kOfRandomLattice[] = {0.424, 1.171};

class PlaneWave : public testing::TestWithParam<int> {};

/// On the triangular lattice, to which the dashpots are matched, what is left of a pulse as wide as
/// four bonds is the mismatch of the boundary points' own mass, of order (bond/width/4)² = 0.4 %,
/// and what the ends of the rows scatter, which have half their bonds and all their mass.
TEST_P(PlaneWave, IsTakenUpByTheViscousBoundaryAndReturnedByTheFixed) {
  const PlacedBody wall = triangular_wall(40, 60);
  const Pulse pulse{wall, 1.0, GetParam(), kOfTriangularLattice[GetParam()], 4.0};
  constexpr double kStep = 0.1;  // the pulse takes about 4 to pass
  const double left = pulse.from(Boundary::kViscous, kStep).left;
  const double returned = pulse.from(Boundary::kFixed, kStep).returned;
  RecordProperty("viscous", std::to_string(left));
  RecordProperty("fixed", std::to_string(returned));
  EXPECT_LT(left, 0.02);
  EXPECT_GT(returned, 0.98);
}

/// On random lattices six spacings wide, the irregularities scatter some per cent. Resets take the
/// less the more often they act.
TEST_P(PlaneWave, OnRandomLatticesIsTakenUpTheBetterTheRarerTheResets) {
  constexpr int kLattices = 3;
  constexpr double kStep = 0.004;
  const double spacing = std::sqrt(M_PI / 1099);
  double viscous = 0.0;
  double reset[] = {0.0, 0.0, 0.0};
  double fixed = 0.0;
  for (int seed = 1; seed <= kLattices; ++seed) {
    Scene scene = wall_scene();
    scene.seed = static_cast<std::uint64_t>(seed);
    scene.wall.width = 2.0;
    scene.wall.height = 3.0;
    scene.wall.points = 2099;  // the disk's density
    const PlacedBody wall = elastic_wall_body(scene, 1099);
    const Pulse pulse{wall, 1.0 / 1099, GetParam(), kOfRandomLattice[GetParam()], 6.0 * spacing};
    viscous += pulse.from(Boundary::kViscous, kStep).left / kLattices;
    reset[0] += pulse.from(Boundary::kReset, 0.001, 0.001).left / kLattices;
    reset[1] += pulse.from(Boundary::kReset, kStep, 0.004).left / kLattices;
    reset[2] += pulse.from(Boundary::kReset, kStep, 0.016).left / kLattices;
    fixed += pulse.from(Boundary::kFixed, kStep).returned / kLattices;
  }
  RecordProperty("viscous", std::to_string(viscous));
  RecordProperty("reset_0.001", std::to_string(reset[0]));
  RecordProperty("reset_0.004", std::to_string(reset[1]));
  RecordProperty("reset_0.016", std::to_string(reset[2]));
  RecordProperty("fixed", std::to_string(fixed));
  // Means of 16 lattices, displacements along x and y: viscous 0.006 and 0.029; resets 0.95 and
  // 0.92, 0.83 and 0.74, 0.50 and 0.32; fixed 0.99 and 0.96. One lattice scatters by 0.01.
  EXPECT_LT(viscous, 0.05);
  EXPECT_LT(viscous, reset[2] - 0.1);
  EXPECT_LT(reset[2], reset[1] - 0.1);
  EXPECT_LT(reset[1], reset[0] - 0.05);
  EXPECT_LT(reset[0], 0.98);
  EXPECT_GT(fixed, 0.95);
}

INSTANTIATE_TEST_SUITE_P(Axis, PlaneWave, testing::Values(0, 1));

}  // namespace
}  // namespace impact
