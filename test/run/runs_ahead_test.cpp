#include "run/runs_ahead.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "kernels/threads.hpp"
#include "run/error_control.hpp"

namespace impact {
namespace {

Scene small_impact() {
  Scene scene;
  scene.disk.recipe.points = 60;
  scene.impact.velocity = 0.05;
  scene.numerics.error = 1e-6;
  return scene;
}

void go_to_the_end(impact::Run& run) {
  while (!run.finished()) run.advance();
}

impact::Run made_alone(const Scene& scene, const std::shared_ptr<const Composition>& composition,
                       const Resolution& resolution) {
  impact::Run run(scene, composition, resolution);
  go_to_the_end(run);
  return run;
}

/// Whoever makes a run, and in whatever order it is asked for.
TEST(RunsAhead, AreThoseThatOneMakesAlone) {
  const Scene scene = small_impact();
  const auto composition = compose_shared(scene);
  const ErrorControl control(scene, *composition);
  std::vector<Resolution> all = control.later_resolutions();
  ASSERT_GE(all.size(), 2U);
  RunsAhead ahead(scene, composition);
  all.insert(all.begin(), control.resolution());
  for (auto present = all.begin(); present != all.end(); ++present) {
    const Resolution& resolution = *present;
    ahead.begin(resolution, {present + 1, all.end()});
    impact::Run run = ahead.take(resolution, {});
    if (present + 1 == all.end()) {
      EXPECT_EQ(run.finished(), threads_of_a_run() > 1);
    }
    go_to_the_end(run);
    const impact::Run alone = made_alone(scene, composition, resolution);
    EXPECT_EQ(run.state().step, alone.state().step);
    EXPECT_TRUE((run.state().position == alone.state().position).all());
    EXPECT_TRUE((run.state().velocity == alone.state().velocity).all());
    EXPECT_EQ(run.tail_error(), alone.tail_error());
  }
}

/// The finest, where there is a processor for it; none that a thread with one to itself asks for.
TEST(RunsAhead, TakeTheProcessorsThatTheyMay) {
  const Scene scene = small_impact();
  const auto composition = compose_shared(scene);
  const auto later = ErrorControl(scene, *composition).later_resolutions();
  RunsAhead ahead(scene, composition);
  const Resolution present = later.front();
  ahead.begin(present, later);
  EXPECT_EQ(ahead.take(later.back(), {}).finished(), threads_of_a_run() > 1);
  std::thread([&] {
    threads_in_a_run() = 1;
    RunsAhead none(scene, composition);
    none.begin(present, later);
    EXPECT_EQ(none.take(later.back(), {}).state().step, 0U);
  }).join();
}

/// It would take hours.
TEST(RunsAhead, AreGivenUpWhenTheyAreNotWantedAnyMore) {
  Scene scene = small_impact();
  scene.numerics.longest = 1e9;
  scene.impact.velocity = 1e-9;
  scene.impact.gap = 1.0;
  scene.numerics.integrator = IntegratorKind::kVerlet;
  const auto composition = compose_shared(scene);
  const auto later = ErrorControl(scene, *composition).later_resolutions();
  RunsAhead ahead(scene, composition);
  ahead.begin(later.front(), later);
  EXPECT_EQ(ahead.take(later.back(), [] { return true; }).state().step, 0U);
  ahead.begin(later.front(), later);
  ahead.begin(later.front(), {});
  EXPECT_EQ(ahead.take(later.back(), {}).state().step, 0U);
}

/// One that breaks off does so again, where its failure is looked for.
TEST(RunsAhead, BeginAnewWhereTheyHaveFailed) {
  Scene scene = small_impact();
  const auto composition = compose_shared(scene);
  Resolution broken = ErrorControl(scene, *composition).resolution();
  const auto unstable = std::make_shared<Composition>(*composition);
  unstable->rates.lattice = {1e-6, 0.0};  // so that nothing shortens the step
  unstable->field.wall.emplace(1.0, 1e-9);
  broken.step = 10.0;
  EXPECT_THROW(made_alone(scene, unstable, broken), RunFailure);
  RunsAhead ahead(scene, unstable);
  ahead.begin(broken, {broken});
  impact::Run run = ahead.take(broken, {});
  EXPECT_EQ(run.state().step, 0U);
  EXPECT_THROW(go_to_the_end(run), RunFailure);
}

}  // namespace
}  // namespace impact
