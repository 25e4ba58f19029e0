#include "measure/flags.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace impact {
namespace {

using Names = std::vector<std::string>;

TEST(Flags, HaveARowEachInTheirOrder) {
  for (std::size_t k = 0; k < kFlags.size(); ++k) {
    EXPECT_EQ(static_cast<std::size_t>(kFlags[k].flag), k) << kFlags[k].name;
    EXPECT_EQ(text_of_flag(kFlags[k].name), &kFlags[k]);
  }
  EXPECT_EQ(static_cast<std::size_t>(Flag::kDisagrees) + 1, kFlags.size());
  EXPECT_EQ(text_of_flag("another"), nullptr);
}

TEST(Flags, AreExplainedInTheDocuments) {
  std::ifstream file(SOURCE_DIR "/doc/results.md");
  const std::string page(std::istreambuf_iterator<char>(file), {});
  const std::string flags = page.substr(page.find("## Flags"));
  for (const FlagText& text : kFlags) {
    EXPECT_NE(flags.find(std::string("`") + text.name + "`"), std::string::npos) << text.name;
  }
}

TEST(Flags, LeaveAnAnswerSoundOrNot) {
  EXPECT_TRUE(is_sound(Names{}));
  EXPECT_TRUE(is_sound(
      Names{"step_reduced", "folded", "hops", "several_rests", "charge_ignored", "floppy"}));
  for (const char* const flag :
       {"starts_in_wall", "cut_off", "energy_error", "beside_wall", "not_separated", "not_at_rest",
        "failed", "interrupted", "incomplete", "damaged", "disagrees", "unheard_of"}) {
    EXPECT_FALSE(is_sound(Names{"hops", flag})) << flag;
  }
}

TEST(Flags, AreFoundInAList) {
  EXPECT_TRUE(has_flag(Names{"hops", "folded"}, Flag::kFolded));
  EXPECT_FALSE(has_flag(Names{"hops"}, Flag::kFolded));
}

}  // namespace
}  // namespace impact
