#include "output/result_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace impact {
namespace {

TEST(Digits, AreThoseThatTheErrorAllows) {
  EXPECT_EQ(digits(0.9987153, 1.4e-6), "0.998715");
  EXPECT_EQ(digits(8.17410312, 2.4e-4), "8.1741");
  EXPECT_EQ(digits(123.456, 2.0), "123");
  EXPECT_EQ(digits(12345.6, 200.0), "1.23e+04");
  EXPECT_EQ(digits(3.34159e-10, 1.2e-13), "3.342e-10");
  EXPECT_EQ(digits(-0.25, 0.001), "-0.250");
  EXPECT_EQ(digits(0.1, 1e-30), "0.100000000000000");  // no more than a double has
}

TEST(Digits, OfWhatIsLessThanItsErrorAreNone) {
  EXPECT_EQ(digits(1e-12, 1e-6), "0");
  EXPECT_EQ(digits(0.0, 1e-6), "0");
}

TEST(Digits, AreSixWhereTheErrorIsNotKnown) {
  EXPECT_EQ(digits(0.123456789, std::nan("")), "0.123457");
  EXPECT_EQ(digits(0.123456789, 0.0), "0.123457");
  EXPECT_EQ(digits(std::nan(""), 1e-6), "not known");
}

Result impact_result() {
  return {{{"velocity", 0.01},
           {"restitution", 0.9987153},
           {"restitution_error", 1.4e-06},
           {"contact_duration", 8.1741031},
           {"contact_duration_error", std::nan("")},
           {"peak_force", 0.0065121},
           {"peak_force_error", 1.0e-08},
           {"flags", std::vector<std::string>{"hops", "new_flag"}}}};
}

/// A disk that meets a smooth wall is not set drifting.
TEST(ResultBlock, LeavesOutRounding) {
  EXPECT_EQ(result_block({{{"tangential_velocity_after", -1e-18},
                           {"spin_after", 2e-17},
                           {"impulse_ratio", -7e-17}}},
                         Scene{}),
            "");
  EXPECT_EQ(result_block({{{"spin_after", 0.25}}}, Scene{}), "  spin after  0.25  c/R\n");
}

TEST(ResultBlock, HasErrorsUnitsAndFlags) {
  EXPECT_EQ(result_block(impact_result(), Scene{}),
            "  restitution e  0.998715   ± 1.4e-06\n"
            "  contact        8.1741               R/c\n"
            "  peak force     0.00651210 ± 1e-08   M c²/R\n"
            "  flag  hops:     energy changes as contacts pass from bond to bond\n"
            "  flag  new_flag:\n");
}

/// R = 2 m, ρ h π R² = 4π kg, √(E/ρ) = √(π 1.082) m/s: R/c = 2 s, M c²/R = 2π N.
TEST(ResultBlock, HasValuesInSi) {
  RealDisk disk;
  disk.radius = 2.0;
  disk.density = 1.0;
  disk.thickness = 1.0;
  disk.wave_speed = std::sqrt(M_PI * 1.082);
  const SiUnits si(disk, Scene{});
  const std::string block = result_block(impact_result(), Scene{}, si);
  EXPECT_NE(block.find("speed          0.01                 c      = 0.01 m/s\n"),
            std::string::npos)
      << block;
  EXPECT_NE(block.find("R/c    = 16.35 s\n"), std::string::npos) << block;
  EXPECT_NE(block.find("M c²/R = 0.04092 N\n"), std::string::npos) << block;
  const YAML::Node values = si_values(impact_result(), Scene{}, si);
  EXPECT_DOUBLE_EQ(values["contact_duration"].as<double>(), 2.0 * 8.1741031);
  EXPECT_EQ(values["units"]["peak_force"].as<std::string>(), "N");
  EXPECT_FALSE(values["restitution"]);
}

TEST(ResultBlock, TakesTheErrorOfAStrainFromTheRun) {
  Scene scene;
  scene.kind = SceneKind::kContact;
  EXPECT_EQ(result_block({{{"strain", 0.0123456789}, {"estimated_error", 1e-4}}}, scene),
            "  strain ξ  0.012346 ± 1.2e-06 R\n");
}

TEST(ResultTable, HasALineARun) {
  Result first = impact_result();
  first.entries.emplace_back("run", 0.0);
  const Result second{{{"run", 1.0},
                       {"velocity", 0.02},
                       {"restitution", std::nan("")},
                       {"contact_duration", std::nan("")},
                       {"peak_force", std::nan("")}}};
  EXPECT_EQ(
      result_table({first, second}, SceneKind::kCollision),
      "run  speed [c]  restitution e        ±  contact [R/c]  peak force [M c²/R]          flags\n"
      "  0       0.01       0.998715  1.4e-06         8.1741           0.00651210  hops,new_flag\n"
      "  1       0.02              -        -              -                    -              "
      "-\n");
}

TEST(ToJson, HasNumbersTextsAndNull) {
  EXPECT_EQ(to_json(YAML::Load("{a: 1.0e-05, b: .nan, c: -.inf, d: [x, true, 3], e: {}, f: 'yes', "
                               "g: \"a\\\"b\\u03be\\n\", h: ~}")),
            R"({"a": 1.0e-05, "b": null, "c": null, "d": ["x", true, 3], "e": {}, "f": "yes", )"
            R"("g": "a\"bξ\n", "h": null})");
}

}  // namespace
}  // namespace impact
