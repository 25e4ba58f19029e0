#include "output/pace.hpp"

#include <gtest/gtest.h>

namespace impact {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(Pace, GivesRateAndTimeLeftSinceTheFirstCall) {
  const Pace::Clock::time_point start;
  Pace pace("runs");
  pace.note(10.0, 110.0, start);
  EXPECT_EQ(pace.text(), "9 %");
  pace.note(20.0, 110.0, start + seconds(5));  // 2 a second, 90 to go
  EXPECT_EQ(pace.text(), "18 %, 2 runs/s, 45 s left");
  pace.note(20.0, 1500.0, start + seconds(5));
  EXPECT_EQ(pace.text(), "1 %, 2 runs/s, 12 min left");
  pace.note(20.0, 50000.0, start + seconds(5));
  EXPECT_EQ(pace.text(), "0 %, 2 runs/s, 6.9 h left");
}

TEST(Pace, IsSilentOfWhatItDoesNotKnow) {
  const Pace::Clock::time_point start;
  Pace pace("runs");
  EXPECT_EQ(pace.text(), "0 %");
  pace.note(3.0, 10.0, start);
  pace.note(3.0, 10.0, start + seconds(100));
  EXPECT_EQ(pace.text(), "30 %");
  pace.note(4.0, 10.0, start + milliseconds(10));
  EXPECT_EQ(pace.text(), "40 %");
}

/// A run may take longer than expected.
TEST(Pace, DoesNotExceedAHundredPerCent) {
  const Pace::Clock::time_point start;
  Pace pace("steps");
  pace.note(0.0, 100.0, start);
  pace.note(1000.0, 100.0, start + seconds(1));
  EXPECT_EQ(pace.text(), "100 %, 1000 steps/s, 0 s left");
}

}  // namespace
}  // namespace impact
