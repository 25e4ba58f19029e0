#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>

#include "counted_heap.hpp"
#include "kernels/threads.hpp"
#include "series/convergence_study.hpp"
#include "small_scenes.hpp"

namespace impact {
namespace {

struct Limit {
  double velocity;  // c
  double bytes;     // a point
};

class MemoryOf : public testing::TestWithParam<Limit> {
 protected:
  MemoryOf() { threads_in_a_run() = 1; }  // as large runs are: one after another
  ~MemoryOf() override { threads_in_a_run() = 0; }
};

/// From the lattice to the answer of three runs. One more number pair a point would be above the
/// limit.
TEST_P(MemoryOf, AnImpactIsWithinTheLimit) {
  constexpr int kPoints = 10000;
  const Scene scene = scenes(fmt::format("{{scene: collision, disk: {{points: {}}}, impact: "
                                         "{{velocity: {}}}, numerics: {{error: 0.01}}}}",
                                         kPoints, GetParam().velocity))
                          .front();
  int runs = 0;
  const std::int64_t bytes = most_bytes_of([&] {
    ConvergenceStudy study(scene);
    while (!study.finished()) study.advance();
    runs = study.runs();
  });
  EXPECT_EQ(runs, 3);
  EXPECT_LT(static_cast<double>(bytes), GetParam().bytes * kPoints);
}

// The end of the faster one is known by the disk's tethers only.
INSTANTIATE_TEST_SUITE_P(Velocities, MemoryOf,
                         testing::Values(Limit{0.02, 325.0}, Limit{0.05, 355.0}));

}  // namespace
}  // namespace impact
