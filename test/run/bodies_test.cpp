#include "run/bodies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "expect_input_error.hpp"
#include "lattice/lammps_writing.hpp"
#include "lattice/placement.hpp"

namespace impact {
namespace {

Scene scene_with_a_wall() {
  Scene scene;
  scene.wall.kind = WallKind::kLattice;
  return scene;
}

/// Scenes of one key are run with the same bodies.
TEST(KeyOfBodies, DependsOnWhatTheBodiesDependOn) {
  const Scene plain = scene_with_a_wall();
  using Change = void (*)(Scene&);
  const Change of_bodies[] = {[](Scene& s) { s.seed = 2; },
                              [](Scene& s) { s.disk.recipe.points = 99; },
                              [](Scene& s) { s.disk.recipe.placement = Placement::kUniform; },
                              [](Scene& s) { s.disk.recipe.rim = false; },
                              [](Scene& s) { s.disk.file = "disk.data"; },
                              [](Scene& s) { s.disk.scale = FileScale::kRadius; },
                              [](Scene& s) { s.wall.points = 99; },
                              [](Scene& s) { s.wall.width = 3.0; },
                              [](Scene& s) { s.wall.height = 3.0; },
                              [](Scene& s) { s.wall.file = "wall.data"; },
                              [](Scene& s) { s.wall.kind = WallKind::kPotential; }};
  std::set<std::string> keys{key_of_bodies(plain)};
  for (const Change change : of_bodies) {
    Scene scene = plain;
    change(scene);
    EXPECT_TRUE(keys.insert(key_of_bodies(scene)).second) << keys.size();
  }
  Scene scene = plain;
  scene.impact.velocity = 0.3;
  scene.material.eta = 3.0;
  scene.wall.a = 500.0;
  EXPECT_EQ(key_of_bodies(scene), key_of_bodies(plain));
  scene.wall.kind = WallKind::kDisk;
  for (int disks = 1; disks <= 3; ++disks) {
    scene.wall.disks = disks;
    EXPECT_TRUE(keys.insert(key_of_bodies(scene)).second) << disks;
  }
}

/// A file may have a radius from 0.8 to 1.2.
TEST(MakeBodies, RefusesAFileOfAnotherRadius) {
  const Lattice disk = triangulated_lattice(place_in_disk({100, Placement::kBlueNoise, true}, 1));
  Scene scene;
  scene.disk.file = testing::TempDir() + "bodies_test.data";
  for (const double radius : {0.7, 0.9, 1.1, 1.3}) {
    write_lammps_data(make_lattice(radius * disk.points, disk.bonds), 0.01, scene.disk.file);
    if (std::abs(radius - 1.0) < 0.2) {
      EXPECT_NO_THROW(make_bodies(scene));
    } else {
      EXPECT_INPUT_ERROR(make_bodies(scene), "the radius is");
    }
  }
}

/// ω² goes with k_a/m and γ with η/m, also where the bodies were made without damping.
TEST(SpectrumOf, ScalesWithTheLawAndTheMass) {
  Scene scene;
  scene.disk.recipe.points = 50;
  const auto undamped = make_bodies(scene);
  scene.material.eta = 1.0;
  const auto damped = make_bodies(scene);
  scene.material = {3.0, 0.0, 10.0};
  const Spectrum direct = lattice_spectrum(damped->disk(), {3.0, 0.0, 10.0 * 0.02}, 0.02);
  for (const auto& bodies : {undamped, damped}) {
    const Spectrum scaled = spectrum_of(scene, *bodies, 0.02);
    // Products in another order.
    EXPECT_NEAR(scaled.omega_squared / direct.omega_squared, 1.0, 1e-12);
    EXPECT_NEAR(scaled.gamma / direct.gamma, 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace impact
