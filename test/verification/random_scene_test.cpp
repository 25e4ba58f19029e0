#include "verification/random_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <vector>

#include "run/compose.hpp"
#include "scene/keys.hpp"
#include "scene/scene_parameters.hpp"
#include "scene/short_keys.hpp"

namespace impact {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr int kScenes = 250;

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> drawn = [] {
    std::vector<Scene> list;
    for (int number = 0; number < kScenes; ++number) {
      list.push_back(random_scene(kSeed, number).scene);
    }
    return list;
  }();
  return drawn;
}

TEST(RandomScene, FollowsFromSeedAndNumber) {
  EXPECT_EQ(to_yaml(random_scene(kSeed, 3).scene), to_yaml(random_scene(kSeed, 3).scene));
  EXPECT_NE(to_yaml(random_scene(kSeed, 3).scene), to_yaml(random_scene(kSeed, 8).scene));
  EXPECT_NE(to_yaml(random_scene(kSeed, 3).scene), to_yaml(random_scene(kSeed + 1, 3).scene));
}

TEST(RandomScene, DrawsSlowImpactsToo) {
  EXPECT_EQ(to_yaml(random_slow_scene(kSeed, 3).scene), to_yaml(random_slow_scene(kSeed, 3).scene));
  for (int number = 0; number < 10; ++number) {
    const Scene scene = random_slow_scene(kSeed, number).scene;
    EXPECT_EQ(kind_of(scene), "potential wall");
    EXPECT_LE(scene.impact.velocity, 0.006 * std::sqrt(scene.material.k_a));
    const IntegratorKind integrator = compose(scene).resolution.integrator;
    EXPECT_EQ(integrator == IntegratorKind::kReduced, !scene.is_damped());
    EXPECT_TRUE(traits_of(integrator).stepping == Stepping::kReduced ||
                integrator == IntegratorKind::kImex);
  }
}

/// Of what is drawn on the way to this scene one would take more than numerics.longest.
TEST(RandomScene, JudgesScenesThatTakeTooLong) { EXPECT_NO_THROW(random_scene(83, 601)); }

TEST(RandomScene, TakesTheKindsInTurn) {
  for (int number = 0; number < kScenes; ++number) {
    const std::string kind = kind_of(scenes()[static_cast<std::size_t>(number)]);
    EXPECT_EQ(kind, number % 5 == 0   ? "contact"
                    : number % 5 == 1 ? "elastic wall"
                                      : "potential wall");
  }
}

struct Range {
  std::string key;
  double low;
  double high;
  double reached_low;   ///< an ensemble of this size goes below
  double reached_high;  ///< and above
};

class Ranges : public testing::TestWithParam<Range> {};

/// No value lies outside; the whole range is there, but for what sensible sizes leave rare.
TEST_P(Ranges, AreCovered) {
  const auto& table = scene_parameters();
  const auto parameter = std::find_if(
      table.begin(), table.end(), [](const auto& entry) { return entry.key == GetParam().key; });
  double least = GetParam().high;
  double most = GetParam().low;
  for (const Scene& scene : scenes()) {
    const auto value = scalar<double>(parameter->write(scene));
    if (!parameter->applies(scene) || !value || *value == 0.0) continue;
    least = std::min(least, *value);
    most = std::max(most, *value);
  }
  EXPECT_GE(least, GetParam().low);
  EXPECT_LE(most, GetParam().high);
  EXPECT_LT(least, GetParam().reached_low);
  EXPECT_GT(most, GetParam().reached_high);
}

INSTANTIATE_TEST_SUITE_P(Keys, Ranges,
                         testing::Values(Range{"disk.points", 3, 3000, 5, 1500},
                                         Range{"wall.a", 30, 1e4, 40, 7e3},
                                         Range{"numerics.error", 1e-9, 1e-2, 2e-9, 5e-3},
                                         Range{"impact.velocity", 1e-4, 0.3, 1e-3, 0.2},
                                         Range{"load.P", 1e-10, 0.3, 1e-9, 0.03},
                                         Range{"material.k_a", 1e-3, 1e3, 5e-3, 200},
                                         Range{"material.k_b", 1e-3, 1e3, 2e-3, 500},
                                         Range{"material.eta", 1e-2, 1e3, 3e-2, 300},
                                         Range{"impact.gap", 0.01, 1.0, 0.02, 0.8},
                                         Range{"wall.points", 20, 3000, 50, 1000},
                                         Range{"wall.threshold", 0.02, 2.0, 0.04, 1.0},
                                         Range{"wall.reset_interval", 1e-3, 0.1, 4e-3, 0.05}));

TEST(RandomScene, DrawsEveryBoundaryPlacementAndRim) {
  const auto any = [](const std::function<bool(const Scene&)>& is) {
    return std::any_of(scenes().begin(), scenes().end(), is);
  };
  for (const Boundary boundary : {Boundary::kReset, Boundary::kFixed, Boundary::kViscous}) {
    EXPECT_TRUE(any([&](const Scene& scene) {
      return kind_of(scene) == "elastic wall" && scene.wall.boundary == boundary;
    }));
  }
  for (const bool rim : {true, false}) {
    for (const Placement placement : {Placement::kUniform, Placement::kBlueNoise}) {
      EXPECT_TRUE(any([&](const Scene& scene) {
        return scene.disk.recipe.rim == rim && scene.disk.recipe.placement == placement;
      }));
    }
  }
}

TEST(RandomScene, IsOfSensibleSize) {
  Scene scene;
  EXPECT_TRUE(is_sensible(scene));
  scene.impact.velocity = 0.31;
  EXPECT_FALSE(is_sensible(scene));
  scene.impact.velocity = 0.01;
  scene.impact.gap = 0.001;  // the wall's energy at its surface is V₀ a point
  EXPECT_FALSE(is_sensible(scene));
  scene.impact.gap = 100.0;
  EXPECT_FALSE(is_sensible(scene));
  scene.kind = SceneKind::kContact;
  scene.load.p = 0.31;
  EXPECT_FALSE(is_sensible(scene));
}

/// The command's words, read as the program reads them, give the scene again.
TEST(ImpactCommand, RepeatsTheScene) {
  for (int number = 0; number < 5; ++number) {
    const Scene& scene = scenes()[static_cast<std::size_t>(number)];
    std::istringstream words(impact_command(scene));
    std::string program;
    std::string file;
    words >> program >> file;
    EXPECT_EQ(program, "impact");
    FlatTree keys = load_keys(std::string(SOURCE_DIR "/") + file);
    for (std::string word; words >> word;) override_keys(keys, {word});
    EXPECT_EQ(to_yaml(parse_scene(keys)), to_yaml(scene));
  }
}

}  // namespace
}  // namespace impact
