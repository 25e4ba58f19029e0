#include "series/convergence_study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scene/keys.hpp"
#include "scene/scene_parameters.hpp"
#include "scene/short_keys.hpp"

namespace impact {
namespace {

Scene scene_of(const std::string& file, const std::vector<std::string>& assignments) {
  FlatTree keys = load_keys(SOURCE_DIR "/launch/scenes/" + file + ".yaml");
  override_keys(keys, assignments);
  return parse_scene(keys);
}

ConvergenceStudy performed(const Scene& scene) {
  ConvergenceStudy study(scene);
  while (!study.finished()) study.advance();
  return study;
}

/// A scene whose answer was once further off than promised, without a word. The true values are
/// from rk8pd with tolerances of 10⁻¹¹ … 10⁻¹³, those of contacts by Newton's method in long
/// double, to all digits that are given.
struct Case {
  std::string name;
  std::string file;
  std::vector<std::string> keys;
  double answer;
};

class AnswerOf : public testing::TestWithParam<Case> {};

TEST_P(AnswerOf, CaseIsWithinTheWantedErrorAndTheEstimatedOne) {
  const Scene scene = scene_of(GetParam().file, GetParam().keys);
  const ConvergenceStudy study = performed(scene);
  const double error = std::abs(study.answer() / GetParam().answer - 1.0);
  EXPECT_LE(error, scene.numerics.error);
  EXPECT_LE(error, study.estimated_error());
}

INSTANTIATE_TEST_SUITE_P(
    Quoted, AnswerOf,
    testing::Values(
        Case{"SpinningTriangleStrikesAgain",
             "collision",
             {"disk.points=3", "seed=3", "impact.velocity=0.05"},
             0.90561675095},
        Case{"SpinningDiskStrikesAgain",
             "collision",
             {"seed=443148", "disk.points=15", "disk.rim=false", "impact.velocity=0.0384105",
              "wall.a=622.791"},
             0.75406746896},
        Case{"HardWall",
             "collision",
             {"seed=754924", "disk.points=1027", "impact.velocity=0.0314025", "wall.a=8114.75",
              "numerics.error=1e-5"},
             0.98288533261},
        Case{"HardWallAndStiffBonds",
             "collision",
             {"seed=678087", "disk.points=11", "disk.rim=false", "impact.velocity=0.0370797",
              "wall.a=4801.84", "material.k_a=217.443", "impact.gap=1", "numerics.error=1e-8"},
             0.68987271722},
        Case{"ElasticWallAtItsStiffest",
             "absorbing_wall",
             {"seed=485271", "disk.points=698", "material.k_b=0", "wall.a=348.346",
              "wall.V0=0.0564853", "wall.threshold=0.958158", "wall.points=1015",
              "wall.width=1.8953", "wall.gap_measure=vertical", "wall.boundary=fixed",
              "impact.velocity=0.0174433", "impact.gap=0.0229266", "numerics.error=5.80249e-6"},
             1.024444856},
        Case{"SlowAndBeginsInTheWall",
             "collision",
             {"seed=24617", "disk.points=192", "wall.a=103.769", "material.k_b=0",
              "impact.velocity=0.00205815", "impact.gap=0.139939", "numerics.error=5.91684e-7"},
             1.11947362677},
        Case{"ContactThatRollsEasily",
             "contact",
             {"seed=192920", "disk.points=7", "material.k_a=0.0237945", "material.k_b=0",
              "material.eta=0", "wall.a=3025.51", "load.P=5.59994e-6", "numerics.integrator=auto",
              "numerics.error=1.89917e-7"},
             2.8643145195500e-4}),
    [](const auto& info) { return info.param.name; });

/// Hops and a cut-off wall leave a scatter above the wanted error: no answer, and the cause.
TEST(Answer, IsRefusedWhereTheContactScatters) {
  const Scene hops = scene_of(
      "absorbing_wall",
      {"seed=340747", "disk.points=9", "disk.placement=uniform", "impact.velocity=0.0548255",
       "material.eta=7.21138", "wall.a=272.465", "material.k_b=0", "material.k_a=0.0250233",
       "wall.boundary=fixed", "wall.threshold=0.534165", "wall.points=144", "wall.width=1.04704",
       "wall.height=1.24024", "impact.gap=1", "numerics.error=1e-6"});
  EXPECT_THROW(performed(hops), RunFailure);
  const Scene cut_off =
      scene_of("absorbing_wall",
               {"seed=352672", "disk.points=28", "impact.velocity=0.0130016", "wall.a=54.4457",
                "material.k_b=6.24203", "wall.boundary=fixed", "wall.gap_measure=vertical",
                "wall.points=44", "wall.width=2.41995", "numerics.error=1e-8"});
  EXPECT_THROW(performed(cut_off), RunFailure);
}

/// A disk that keeps 2 % of its energy, of which the wall's tail would be 50 times as much as of
/// what went in: the start is lifted, so that e is that of a start much further away.
TEST(Answer, CountsTheTailOfTheWallAgainstWhatIsLeft) {
  std::vector<std::string> keys{"disk.points=8",     "disk.placement=uniform",
                                "disk.rim=false",    "impact.velocity=0.005",
                                "material.k_a=0.01", "material.k_b=1e-5"};
  const ConvergenceStudy lifted = performed(scene_of("collision", keys));
  ASSERT_LT(lifted.answer(), 0.15);
  keys.emplace_back("impact.gap=0.3");
  const ConvergenceStudy far = performed(scene_of("collision", keys));
  EXPECT_NEAR(far.answer() / lifted.answer(), 1.0,
              far.estimated_error() + lifted.estimated_error());
  // A tail of at most a tenth of the error, as a part of what is left.
  EXPECT_LT(lifted.run().restitution_bound(), 1.0 + 0.1 * 1e-4 * std::pow(lifted.answer(), 2));
}

/// At the end of a run the wall still holds up to ε/10⁴ of the energy of a slow disk. Counted as
/// velocity, what is left of that error is less than a tenth.
TEST(Answer, CountsWhatTheWallStillHoldsAtTheEnd) {
  const std::vector<std::string> keys{"disk.points=100", "impact.velocity=0.003", "impact.gap=0.2",
                                      "numerics.integrator=verlet"};
  std::vector<std::string> rough = keys;
  rough.emplace_back("numerics.error=1e-3");
  std::vector<std::string> fine = keys;
  fine.emplace_back("numerics.error=1e-9");
  const ConvergenceStudy answer = performed(scene_of("collision", rough));
  const double true_value = performed(scene_of("collision", fine)).answer();
  EXPECT_LT(std::abs(answer.answer() - true_value),
            0.1 * std::abs(answer.restitution_of_run().restitution - true_value));
}

/// ξ of a light load is known as far as positions can be told apart: whatever V₀ shifts the disk
/// by, it is the same within the estimates.
TEST(Answer, OfALightLoadHasTheErrorOfRounding) {
  const auto strain = [](const char* v0) {
    return performed(scene_of(
        "contact", {"numerics.integrator=newton", "load.P=1e-7", v0, "numerics.error=1e-8"}));
  };
  const ConvergenceStudy reference = strain("wall.V0=1");
  EXPECT_GT(reference.estimated_error(), 1e-9);
  for (const char* const v0 : {"wall.V0=0.7", "wall.V0=1.23", "wall.V0=10"}) {
    const ConvergenceStudy other = strain(v0);
    EXPECT_LE(std::abs(other.answer() / reference.answer() - 1.0),
              reference.estimated_error() + other.estimated_error());
  }
}

/// The answer is drawn from three runs; the last one by itself is as far off as it says.
TEST(Answer, IsBetterThanTheLastRun) {
  const ConvergenceStudy coarse = performed(scene_of("collision", {"impact.velocity=0.05"}));
  const ConvergenceStudy fine =
      performed(scene_of("collision", {"impact.velocity=0.05", "numerics.error=1e-9"}));
  const double true_value = fine.answer();
  const double of_run = coarse.restitution_of_run().restitution;
  EXPECT_GT(std::abs(of_run - true_value), 20.0 * std::abs(coarse.answer() - true_value));
  EXPECT_LE(std::abs(of_run - true_value), coarse.impact().error_of_run);
  EXPECT_LE(std::abs(coarse.answer() - true_value), coarse.impact().error.restitution);
}

/// Every number of an oblique impact is within its own error, on a soft and on a hard wall.
TEST(Answer, HasAnErrorForEveryNumber) {
  for (const char* const a : {"wall.a=300", "wall.a=3000"}) {
    const std::vector<std::string> keys{"disk.points=100", "impact.velocity=0.05",
                                        "impact.angle=20", "impact.spin=0.01", a};
    const ImpactAnswer coarse = performed(scene_of("collision", keys)).impact();
    std::vector<std::string> finer = keys;
    finer.emplace_back("numerics.integrator=verlet");
    finer.emplace_back("numerics.step=2e-5");
    const ImpactAnswer fine = performed(scene_of("collision", finer)).impact();
    // What rounding leaves of a vanishing number is 1e-15.
    for (const auto& [name, number] : impact_numbers<Restitution>()) {
      if (disk_of(name) != 0 || is_of_row(name)) {
        EXPECT_TRUE(std::isnan(coarse.value.*number)) << name;
        continue;
      }
      EXPECT_LE(std::abs(coarse.value.*number - fine.value.*number), coarse.error.*number + 1e-15)
          << name << " " << a;
    }
  }
}

/// The same of a row, whose three disks other than the first have numbers of their own.
TEST(Answer, HasAnErrorForEveryDiskOfARow) {
  const std::vector<std::string> keys{"disk.points=30",     "impact.velocity=0.05",
                                      "impact.angle=20",    "wall.disks=3",
                                      "wall.mirrored=true", "numerics.error=1e-3"};
  const ImpactAnswer coarse = performed(scene_of("disk_on_disk", keys)).impact();
  std::vector<std::string> finer = keys;
  finer.emplace_back("numerics.integrator=verlet");
  finer.emplace_back("numerics.step=1e-3");
  const ImpactAnswer fine = performed(scene_of("disk_on_disk", finer)).impact();
  for (const auto& [name, number] : impact_numbers<Restitution>()) {
    if (is_read_off_steps(name)) continue;
    EXPECT_LE(std::abs(coarse.value.*number - fine.value.*number), coarse.error.*number + 1e-8)
        << name;
  }
}

TEST(Quantities, AreThoseOfTheDisksThatAreThere) {
  const auto has = [](const std::string& file, const std::string& disks, const std::string& key) {
    const auto list = quantities(scene_of(file, {disks}));
    return std::any_of(list.begin(), list.end(), [&](const auto& one) { return one.key == key; });
  };
  EXPECT_FALSE(has("collision", "seed=1", "wall_spin_after"));
  EXPECT_TRUE(has("disk_on_disk", "wall.disks=1", "wall_spin_after"));
  EXPECT_TRUE(has("disk_on_disk", "wall.disks=1", "wall_velocity_after_error"));
  EXPECT_FALSE(has("disk_on_disk", "wall.disks=1", "wall2_spin_after"));
  EXPECT_FALSE(has("disk_on_disk", "wall.disks=1", "momentum_passed_on"));
  EXPECT_TRUE(has("disk_on_disk", "wall.disks=2", "wall2_spin_after"));
  EXPECT_FALSE(has("disk_on_disk", "wall.disks=2", "wall3_spin_after"));
  EXPECT_TRUE(has("disk_on_disk", "wall.disks=2", "momentum_passed_on"));
}

/// Waves along a bar: √(E/ρ), ρ = 1/π. The grips pull a little harder than the middle, since the
/// rim is stiffer.
TEST(Result, OfAStretchHasTheSpeedOfSound) {
  const Result result = performed(scene_of("stretch", {})).result();
  const auto young_modulus = result.number("young_modulus");
  EXPECT_NEAR(young_modulus, 1.082, 0.1);
  EXPECT_NEAR(result.number("sound_speed"), std::sqrt(M_PI * young_modulus), 1e-12);
  EXPECT_NEAR(result.number("grip_modulus"), young_modulus, 0.1 * young_modulus);
}

}  // namespace
}  // namespace impact
