#include "lattice/lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "expect_input_error.hpp"

namespace impact {
namespace {

PointArray unit_square() {
  PointArray points(4, 2);
  points << 0, 0, 1, 0, 1, 1, 0, 1;
  return points;
}

TEST(MakeLattice, NaturalLengthsAreTheReferenceDistances) {
  const Lattice lattice = make_lattice(unit_square(), {{0, 2}, {0, 1}, {1, 2}, {2, 3}, {0, 3}});
  const std::vector<Bond> sorted{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}};
  EXPECT_EQ(lattice.bonds, sorted);
  const std::vector<double> lengths{1.0, std::sqrt(2.0), 1.0, 1.0, 1.0};
  EXPECT_EQ(lattice.natural_lengths, lengths);
}

TEST(MakeLattice, RefusesWhatIsNoLattice) {
  EXPECT_INPUT_ERROR(make_lattice(unit_square().topRows(2), {{0, 1}}), "at least 3 points, got 2");
  EXPECT_INPUT_ERROR(make_lattice(unit_square(), {{0, 1}, {2, 3}}), "in 2 pieces");
  EXPECT_INPUT_ERROR(make_lattice(unit_square(), {{0, 1}, {1, 2}, {2, 3}, {0, 1}}),
                     "points 1 and 2 are bonded twice");

  PointArray line(4, 2);
  line << 0, 0, 1, 1, 2, 2, 3, 3;
  EXPECT_INPUT_ERROR(make_lattice(line, {{0, 1}, {1, 2}, {2, 3}}), "on one line");

  PointArray coincident = unit_square();
  coincident.row(1) = coincident.row(0);
  EXPECT_INPUT_ERROR(make_lattice(coincident, {{0, 1}, {1, 2}, {2, 3}}), "points 1 and 2 coincide");

  PointArray not_a_number = unit_square();
  not_a_number(2, 0) = std::nan("");
  EXPECT_INPUT_ERROR(make_lattice(not_a_number, {{0, 1}, {1, 2}, {2, 3}}), "not finite");
}

TEST(TriangulatedLattice, KeepsThePointsAndBondsThemAsTheTriangulationDoes) {
  PointArray points(5, 2);
  points << 0, 0, 2, 0.1, 2.1, 2, 0.1, 2.2, 1, 1;
  const Lattice lattice = triangulated_lattice(points);
  EXPECT_EQ(lattice.bonds.size(), 8U);  // 4 on the hull and 4 to the middle
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const auto offset = lattice.points.rowwise() - points.row(i);
    EXPECT_EQ((offset.abs().rowwise().sum() == 0.0).count(), 1) << "point " << i;
  }
}

TEST(Joined, KeepsBothLatticesSideBySide) {
  const Lattice square = make_lattice(unit_square(), {{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 2}});
  PointArray points(3, 2);
  points << 5, 0, 8, 0, 5, 4;
  const Lattice triangle = make_lattice(points, {{0, 1}, {0, 2}, {1, 2}});
  const Lattice both = joined(square, triangle);
  ASSERT_EQ(both.points.rows(), 7);
  EXPECT_TRUE((both.points.topRows(4) == square.points).all());
  EXPECT_TRUE((both.points.bottomRows(3) == triangle.points).all());
  const std::vector<Bond> bonds{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}, {4, 5}, {4, 6}, {5, 6}};
  EXPECT_EQ(both.bonds, bonds);
  const std::vector<double> lengths{1.0, std::sqrt(2.0), 1.0, 1.0, 1.0, 3.0, 4.0, 5.0};
  EXPECT_EQ(both.natural_lengths, lengths);
}

}  // namespace
}  // namespace impact
