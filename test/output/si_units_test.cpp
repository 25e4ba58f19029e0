#include "output/si_units.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "expect_input_error.hpp"

namespace impact {
namespace {

constexpr double kModulus = 1.082;  // of blue noise, M c²/R², as disk_elasticity() has it

double in_si(const SiUnits& si, const std::string& unit) { return si.in_si(1.0, unit)->value; }

/// Rubber: E h = 1.082 M c²/R², with M = ρ π R² h.
TEST(SiUnits, FollowFromTheMaterial) {
  const SiUnits si(parse_real_disk("radius=0.05,density=1100,young=5e6,thickness=0.01"), Scene{});
  const double mass = 1100.0 * M_PI * 0.05 * 0.05 * 0.01;
  EXPECT_DOUBLE_EQ(si.mass(), mass);
  EXPECT_DOUBLE_EQ(kModulus * si.mass() * si.speed() * si.speed() / (0.05 * 0.05), 5e6 * 0.01);
  const double r = 0.05;
  const double c = si.speed();
  EXPECT_DOUBLE_EQ(in_si(si, "R"), r);
  EXPECT_DOUBLE_EQ(in_si(si, "c"), c);
  EXPECT_DOUBLE_EQ(in_si(si, "R/c"), r / c);
  EXPECT_DOUBLE_EQ(in_si(si, "c/R"), c / r);
  EXPECT_DOUBLE_EQ(in_si(si, "M"), mass);
  EXPECT_DOUBLE_EQ(in_si(si, "M c"), mass * c);
  EXPECT_DOUBLE_EQ(in_si(si, "M c/R"), mass * c / r);
  EXPECT_DOUBLE_EQ(in_si(si, "M c²"), mass * c * c);
  EXPECT_DOUBLE_EQ(in_si(si, "M c²/R"), mass * c * c / r);
  EXPECT_DOUBLE_EQ(in_si(si, "M c²/R²"), mass * c * c / (r * r));
  EXPECT_EQ(si.in_si(1.0, "M c²/R")->unit, "N");
  EXPECT_EQ(si.in_si(1.0, "M c²/R²")->unit, "N/m");
  EXPECT_FALSE(si.in_si(1.0, ""));
}

/// A wave along a bar takes the same time over R in both.
TEST(SiUnits, KeepTheWaveSpeed) {
  const SiUnits si(parse_real_disk("radius=0.05,density=1100,wave_speed=60"), Scene{});
  EXPECT_DOUBLE_EQ(std::sqrt(M_PI * kModulus) * si.speed(), 60.0);
  Scene stiff;
  stiff.material.k_a = 4.0;  // its waves run at twice as many c
  EXPECT_DOUBLE_EQ(
      SiUnits(parse_real_disk("radius=0.05,density=1100,wave_speed=60"), stiff).speed(),
      0.5 * si.speed());
}

TEST(SiUnits, WithoutAThicknessAreForEachMetre) {
  const SiUnits thin(parse_real_disk("radius=0.05,density=1100,young=5e6,thickness=0.01"), Scene{});
  const SiUnits si(parse_real_disk("radius=0.05,density=1100,young=5e6"), Scene{});
  EXPECT_DOUBLE_EQ(si.speed(), thin.speed());
  EXPECT_DOUBLE_EQ(0.01 * in_si(si, "M c²/R"), in_si(thin, "M c²/R"));
  EXPECT_EQ(si.in_si(1.0, "M c²/R")->unit, "N/m");
  EXPECT_EQ(si.in_si(1.0, "R/c")->unit, "s");
}

TEST(SiUnits, TakeAMassInsteadOfADensity) {
  const SiUnits by_density(parse_real_disk("radius=0.05,density=1100,young=5e6,thickness=0.01"),
                           Scene{});
  const SiUnits by_mass(parse_real_disk(fmt::format("radius=0.05,mass={},young=5e6,thickness=0.01",
                                                    by_density.mass())),
                        Scene{});
  EXPECT_DOUBLE_EQ(by_mass.speed(), by_density.speed());
}

TEST(SiUnits, NeedAKnownLattice) {
  Scene scene;
  scene.disk.file = "mine.data";
  EXPECT_INPUT_ERROR(SiUnits(parse_real_disk("radius=1,density=1,young=1"), scene),
                     "disk.file: the Young's modulus of this lattice is not known");
}

TEST(ParseRealDisk, SaysWhatIsMissing) {
  EXPECT_INPUT_ERROR(parse_real_disk("density=1,young=1"), "radius: got nothing");
  EXPECT_INPUT_ERROR(parse_real_disk("radius=1,young=1"),
                     "density and mass: got nothing, allowed: one");
  EXPECT_INPUT_ERROR(parse_real_disk("radius=1,density=1,young=1,wave_speed=1"),
                     "young and wave_speed: got both");
  EXPECT_INPUT_ERROR(parse_real_disk("radius=1,mass=1,young=1"), "thickness: got nothing");
  EXPECT_INPUT_ERROR(parse_real_disk("radius=0,density=1,young=1"),
                     "radius: got 0, allowed: number in (0");
  EXPECT_INPUT_ERROR(parse_real_disk("radius=1,radius=1"), "radius: given twice");
  EXPECT_INPUT_ERROR(parse_real_disk("radius"), "radius: allowed: key=value");
  EXPECT_INPUT_ERROR(parse_real_disk("radius=1,denstiy=1,young=1"),
                     "denstiy: unknown key (did you mean density?)");
}

}  // namespace
}  // namespace impact
