#include "run/lammps_course.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "expect_input_error.hpp"

namespace impact {
namespace {

/// A folder as LAMMPS leaves it after an impact at 2 c with e = 1/2, in 100 steps of 0.25 R/c.
class LammpsCourseTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) / "lammps_course_test";
    std::filesystem::create_directories(folder_);
    std::string forces = "# Time-averaged data for fix force\n# TimeStep c_force\n";
    for (int step = 0; step <= 100; ++step) {
      forces += fmt::format("{} {}\n", step, 0.0625 * std::max(0, 10 - std::abs(step - 50)));
    }
    write("force.txt", forces);
    write("motion.txt", kStart + kEnd);
    scene_.impact.velocity = 2.0;
    scene_.numerics.step = 0.25;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  LammpsCourse read() const { return read_lammps_course(folder_, 0.25); }
  LammpsAnswer answer() const { return answer_of(read(), scene_); }

  /// Step, centre, its velocity, angular momentum, moment of inertia, kinetic energy, bonds.
  const std::string kStart = "# TimeStep v_x\n0 0 1 0 -2 0 0.5 2 0\n";
  const std::string kEnd = "100 0 1.5 0 1 0.125 0.5 0.5 1.5\n";
  std::filesystem::path folder_;
  Scene scene_;
};

TEST_F(LammpsCourseTest, MeasuresAsImpactDoes) {
  const LammpsAnswer result = answer();
  EXPECT_EQ(result.impact.restitution, 0.5);
  EXPECT_EQ(result.impact.spin_after, 0.25);
  EXPECT_EQ(result.impact.peak_force, 0.625);
  EXPECT_DOUBLE_EQ(result.impact.impulse, 6.25 * 0.25);
  // A thousandth of the peak is crossed a hundredth of a step behind 10 R/c and before 15 R/c.
  EXPECT_NEAR(result.impact.contact_begin, 10.0025, 1e-12);
  EXPECT_NEAR(result.impact.contact_end, 14.9975, 1e-12);
  EXPECT_EQ(result.energy_error, 0.0);
  EXPECT_EQ(result.steps, 100U);
  EXPECT_TRUE(result.flags.empty());
}

TEST_F(LammpsCourseTest, SaysThatTheDiskHasNotLeft) {
  write("motion.txt", kStart + "100 0 0.5 0 1 0 0.5 0.5 1.5\n");
  const LammpsAnswer result = answer();
  EXPECT_TRUE(std::isnan(result.impact.restitution));
  EXPECT_EQ(result.flags, std::vector<std::string>{"not_separated"});
}

TEST_F(LammpsCourseTest, SaysThatTheEnergyDrifts) {
  write("motion.txt", kStart + "100 0 1.5 0 1 0 0.5 0.5 1.501\n");
  const LammpsAnswer result = answer();
  EXPECT_NEAR(result.energy_error, 0.001 / 2.001, 1e-12);
  EXPECT_EQ(result.flags, std::vector<std::string>{"energy_error"});
}

/// A force of 0.6 is an energy of 0.6/300, one thousandth of the disk's.
TEST_F(LammpsCourseTest, SaysThatTheWallReachesTheStart) {
  std::string forces;
  for (int step = 0; step <= 100; ++step) {
    forces += std::to_string(step) + (step == 0 ? " 0.6\n" : " 0\n");
  }
  write("force.txt", forces);
  EXPECT_EQ(answer().flags, (std::vector<std::string>{"starts_in_wall", "energy_error"}));
}

TEST_F(LammpsCourseTest, LeavesOutAHalfWrittenLine) {
  write("motion.txt", kStart + kEnd + "200 0 1.");
  EXPECT_EQ(read().looks.size(), 2U);
}

TEST_F(LammpsCourseTest, RefusesWhatItDoesNotKnow) {
  write("motion.txt", kStart + "100 0 1.5 0 1 0.125 0.5 0.5\n");
  EXPECT_INPUT_ERROR(read(), "motion.txt:3: expected 9 finite numbers");
  write("motion.txt", kStart + "100 0 1.5 0 1 0.125 0.5 0.5 nan\n");
  EXPECT_INPUT_ERROR(read(), "motion.txt:3: expected 9 finite numbers");
  write("motion.txt", kStart + "100 0 1.5 0 1 0.125 0.5 0.5 1.5 7\n");
  EXPECT_INPUT_ERROR(read(), "motion.txt:3: expected 9 finite numbers");
  write("motion.txt", kStart + "200 0 1.5 0 1 0.125 0.5 0.5 1.5\n");
  EXPECT_INPUT_ERROR(read(), "motion.txt:3: step 200, expected 100");
  write("motion.txt", "# TimeStep\n");
  EXPECT_INPUT_ERROR(read(), "motion.txt: has no step");
}

TEST_F(LammpsCourseTest, RefusesForcesThatEndBeforeTheMotion) {
  write("force.txt", "0 0\n1 0\n");
  EXPECT_INPUT_ERROR(read(), "force.txt: ends at step 1, motion.txt at step 100");
  std::filesystem::remove(folder_ / "force.txt");
  EXPECT_INPUT_ERROR(read(), "force.txt: cannot be read");
}

}  // namespace
}  // namespace impact
