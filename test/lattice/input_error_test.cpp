#include "lattice/input_error.hpp"

#include <gtest/gtest.h>

namespace impact {
namespace {

TEST(Printable, LeavesTextAsItIs) {
  EXPECT_EQ(printable("v = 0.1 c, η* = 10⁴ …"), "v = 0.1 c, η* = 10⁴ …");
  EXPECT_EQ(printable(""), "");
}

TEST(Printable, EscapesControlCharacters) {
  EXPECT_EQ(printable("a\nb\x1b[31m\x7f"), "a\\x0ab\\x1b[31m\\x7f");
  EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b");  // U+009B, which begins a command of a terminal
}

/// A lone byte, a character cut off at the end, one written too long, and half of a pair.
TEST(Printable, EscapesWhatIsNoUtf8) {
  EXPECT_EQ(printable("a\xe3z"), "a\\xe3z");
  EXPECT_EQ(printable("\xe2\x80"), "\\xe2\\x80");
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");
}

TEST(InputError, IsOneLine) { EXPECT_STREQ(InputError("a\nb").what(), "a\\x0ab"); }

TEST(Shown, CutsBetweenCharacters) {
  std::string text(99, 'a');
  text += "ηb";
  EXPECT_EQ(shown(text), std::string(99, 'a') + "… (102 bytes)");
  EXPECT_EQ(shown("short"), "short");
}

}  // namespace
}  // namespace impact
