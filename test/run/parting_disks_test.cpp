#include "run/parting_disks.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "mechanics/simulation.hpp"
#include "run/compose.hpp"
#include "run/expected_time.hpp"

namespace impact {
namespace {

/// A disk that has hit a row of two, all of 1 M: it flies up, 5 R away, while the row moves down,
/// 0.15 R from disk to disk.
class RowLeftBehind : public testing::Test {
 protected:
  RowLeftBehind() : composition_(compose(scene())), state_(composition_.initial) {
    rows(0, state_.position).col(1) += 5.0;
    leave(0.15);
    state_.velocity.col(0) = 0.0;
    move(0, kVelocity);
    move(1, -0.5 * kVelocity);
    move(2, -0.5 * kVelocity);
  }

  static Scene scene() {
    Scene scene;
    scene.disk.recipe.points = 60;
    scene.wall.kind = WallKind::kDisk;
    scene.wall.disks = 2;
    scene.wall.mirrored = true;
    scene.impact.velocity = kVelocity;
    return scene;
  }

  Eigen::Ref<PointArray> rows(std::size_t body, PointArray& points) const {
    const Body of = composition_.field.body(body);
    return points.middleRows(of.first, of.points);
  }
  /// Below the second disk, R.
  void leave(double gap) {
    const double bottom = rows(1, state_.position).col(1).minCoeff();
    rows(2, state_.position).col(1) += bottom - gap - rows(2, state_.position).col(1).maxCoeff();
  }
  void move(std::size_t body, double velocity) { rows(body, state_.velocity).col(1) = velocity; }

  /// M c², before the impact.
  double impact_energy() const {
    return impact::impact_energy(scene(), composition_.field.reduced_mass());
  }
  bool is_over() const {
    const Simulation system(composition_.field, state_, composition_.rates.lattice, 1e-3);
    PartingDisks disks(scene(), *composition_.bodies);
    return disks.energy_bound(system, 1e-4) <= 1e-4;
  }

  static constexpr double kVelocity = 0.01;
  Composition composition_;
  State state_;
};

TEST_F(RowLeftBehind, IsOverWhereTheOthersStandStill) { EXPECT_TRUE(is_over()); }

/// Two disks of 1 M that come together with v each have the energy M v².
TEST_F(RowLeftBehind, GoesOnWhileTheOthersApproach) {
  const auto approach = [&](double energy) {
    const double v = std::sqrt(energy);
    move(1, -0.5 * kVelocity - v);
    move(2, -0.5 * kVelocity + v);
  };
  approach(0.9e-3 * impact_energy());
  EXPECT_TRUE(is_over());
  approach(1.1e-3 * impact_energy());
  EXPECT_FALSE(is_over());
}

TEST_F(RowLeftBehind, GoesOnWhileTheOthersArePressed) {
  const DiskContacts& contacts = *composition_.field.disk_contacts;
  const double gap = contacts.gap_of_energy(remaining_fraction(scene()) * impact_energy());
  leave(gap + 5.0 / contacts.a());
  EXPECT_TRUE(is_over());
  leave(gap - 5.0 / contacts.a());
  EXPECT_FALSE(is_over());
}

}  // namespace
}  // namespace impact
