#include "scene/keys.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "expect_input_error.hpp"

namespace impact {
namespace {

TEST(ParseValue, IsOneDocumentOfYaml) {
  EXPECT_EQ(parse_value("seed", "7").as<int>(), 7);
  EXPECT_INPUT_ERROR(parse_value("seed", "[1"), "seed: ");
  EXPECT_INPUT_ERROR(parse_value("seed", "1\n...\n2"), "seed: allowed: one YAML document");
  EXPECT_INPUT_ERROR(parse_value("seed", ","), "seed: allowed: one YAML document");
  EXPECT_INPUT_ERROR(parse_value("seed", std::string("1\0", 2)),
                     "seed: got the control character \\x00");
  EXPECT_INPUT_ERROR(parse_value("seed", "1\x04"), "seed: got the control character \\x04");
}

TEST(LoadKeys, SaysWhyAFileCannotBeUsed) {
  EXPECT_INPUT_ERROR(load_keys("/nowhere/scene.yaml"), "cannot be read");
  const std::string path = testing::TempDir() + "broken_scene.yaml";
  std::ofstream(path) << "scene: collision\nimpact: {velocity: 0.01\n";
  EXPECT_INPUT_ERROR(load_keys(path), "broken_scene.yaml:3: ");
  for (const char* const second : {"---\nscene: contact\n", "...\nscene: contact\n"}) {
    std::ofstream(path) << "scene: collision\n" << second;
    EXPECT_INPUT_ERROR(load_keys(path), "broken_scene.yaml: allowed: one YAML document");
  }
  std::ofstream(path) << "---\nscene: collision\n...\n";
  EXPECT_EQ(load_keys(path).size(), 1U);
}

}  // namespace
}  // namespace impact
