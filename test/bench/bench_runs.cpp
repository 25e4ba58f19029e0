// What runs cost: the forces of the bonds, a step of every integrator, static solutions, an impact,
// a sweep.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "kernels/threads.hpp"
#include "mechanics/lane_field.hpp"
#include "mechanics/simulation.hpp"
#include "run/compose.hpp"
#include "run/make_integrator.hpp"
#include "run/resolution.hpp"
#include "run/run.hpp"
#include "series/convergence_study.hpp"
#include "series/series.hpp"
#include "statics/equilibrium_solver.hpp"

namespace impact {
namespace {

using benchmark::Counter;

Counter per_iteration(double count) { return Counter(count, Counter::kIsIterationInvariantRate); }
Counter in_all(double count) { return Counter(count, Counter::kIsRate); }

const Lattice& disk(int points) {
  static std::map<int, Lattice> made;
  const auto found = made.find(points);
  if (found != made.end()) return found->second;
  return made.emplace(points, triangulated_lattice(place_in_disk({points}, 1))).first->second;
}

double bonds_of(const Scene& scene) {
  return static_cast<double>(disk(scene.disk.recipe.points).bonds.size());
}

/// The disk alone, one per cent too large and growing, so that no bond is at rest.
template <bool kCubic, bool kDamped>
void force_evaluation(benchmark::State& state) {
  const Lattice& lattice = disk(static_cast<int>(state.range(0)));
  const double mass = 1.0 / static_cast<double>(state.range(0));
  ForceField field{BondForces(lattice, {1.0, kCubic ? 1e-3 : 0.0, kDamped ? mass : 0.0}), mass};
  const PointArray position = 1.01 * lattice.points;
  PointArray force(position.rows(), 2);
  for (auto _ : state) {
    benchmark::DoNotOptimize(field.evaluate(position, lattice.points, force));
    benchmark::ClobberMemory();
  }
  state.counters["bonds/s"] = per_iteration(static_cast<double>(lattice.bonds.size()));
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(1000)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMicrosecond);
}

BENCHMARK(force_evaluation<false, false>)->Apply(sizes);
BENCHMARK(force_evaluation<true, false>)->Apply(sizes);
BENCHMARK(force_evaluation<false, true>)->Apply(sizes);
BENCHMARK(force_evaluation<true, true>)->Apply(sizes);

/// The same by one thread or on all processors (0), in an impact, for where threads begin to pay.
void step_by_threads(benchmark::State& state) {
  Scene scene;
  scene.disk.recipe.points = static_cast<int>(state.range(0));
  scene.numerics.integrator = IntegratorKind::kVerlet;
  threads_in_a_run() = static_cast<int>(state.range(1));
  const Composition start = compose(scene);
  Simulation simulation(start.field, start.initial, start.rates.lattice, start.resolution.step);
  for (auto _ : state) simulation.step();
  state.counters["bonds/s"] = per_iteration(bonds_of(scene));
}
BENCHMARK(step_by_threads)
    ->ArgNames({"N", "threads"})
    ->ArgsProduct({{1099, 10000, 30000, 100000, 200000, 400000, 1000000}, {1, 0}})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

/// As force_evaluation, of kLanes runs side by side, at the wall.
template <bool kDamped>
void force_evaluation_in_lanes(benchmark::State& state) {
  Scene scene;
  scene.disk.recipe.points = static_cast<int>(state.range(0));
  scene.impact.gap = 0.0;
  if (kDamped) scene.material.eta = 1.0;
  Composition start = compose(scene);
  LaneField field(start.bodies->disk(), start.field.point_mass, LaneField::kind_of(start.field));
  LaneState lanes;
  LaneArray force;
  for (LaneArray* const array : {&lanes.position, &lanes.velocity, &force}) field.resize(*array);
  for (int lane = 0; lane < kLanes; ++lane) {
    field.set_lane(lane, start.field);
    lanes.position.lane(lane) = start.initial.position;
    lanes.velocity.lane(lane) = start.bodies->disk().points;
  }
  for (auto _ : state) {
    field.evaluate(lanes.position, lanes.velocity, force);
    benchmark::ClobberMemory();
  }
  state.counters["bonds/s"] = per_iteration(kLanes * bonds_of(scene));
}
void lane_sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(1000)->Arg(10000)->Arg(30000)->Arg(100000)->Unit(benchmark::kMicrosecond);
}
BENCHMARK(force_evaluation_in_lanes<false>)->Apply(lane_sizes);
BENCHMARK(force_evaluation_in_lanes<true>)->Apply(lane_sizes);

/// The default impact, again and again.
template <IntegratorKind kIntegrator>
void step(benchmark::State& state) {
  constexpr double kEnd = 10.0;  // R/c, when the disk has just left the wall
  Scene scene;
  scene.numerics.integrator = kIntegrator;
  scene.material.eta = static_cast<double>(state.range(0));
  const Composition start = compose(scene);
  std::optional<Simulation> simulation;
  double evaluations = 0.0;
  double time = 0.0;
  const auto begin = [&] {
    simulation.emplace(start.field, start.initial, start.rates.lattice, start.resolution.step,
                       make_integrator(scene, start.resolution, start.rates.sound_speed));
  };
  const auto count = [&] {
    evaluations += static_cast<double>(simulation->field().evaluations);
    time += simulation->state().time;
  };
  begin();
  for (auto _ : state) {
    simulation->step();
    if (simulation->state().time < kEnd) continue;
    state.PauseTiming();
    count();
    begin();
    state.ResumeTiming();
  }
  count();
  state.counters["bonds/s"] = in_all(evaluations * bonds_of(scene));
  state.counters["simulated R/c/s"] = in_all(time);
}

BENCHMARK(step<IntegratorKind::kVerlet>)->ArgName("eta")->Arg(0)->Arg(1);
BENCHMARK(step<IntegratorKind::kBlanesMoan>)->ArgName("eta")->Arg(0);
BENCHMARK(step<IntegratorKind::kImplicitDamping>)->ArgName("eta")->Arg(1);
BENCHMARK(step<IntegratorKind::kExtrapolatedDamping>)->ArgName("eta")->Arg(1);
BENCHMARK(step<IntegratorKind::kBdf>)->ArgName("eta")->Arg(1);
BENCHMARK(step<IntegratorKind::kRk8pd>)->ArgName("eta")->Arg(0)->Arg(1);

/// One run of the default impact, with the step that `auto` tries first, without the lattice.
void run(benchmark::State& state) {
  const Scene scene;
  const auto start = compose_shared(scene);
  double evaluations = 0.0;
  for (auto _ : state) {
    Run run(scene, start);
    while (!run.finished()) run.advance();
    evaluations += static_cast<double>(run.system().field().evaluations);
  }
  state.counters["bonds/s"] = in_all(evaluations * bonds_of(scene));
}
BENCHMARK(run)->Unit(benchmark::kMillisecond);

/// From the default scene to its answer: the lattice, and as many runs as the wanted error takes.
void impact_to_answer(benchmark::State& state) {
  const Scene scene;
  for (auto _ : state) {
    ConvergenceStudy study(scene);
    while (!study.finished()) study.advance();
    benchmark::DoNotOptimize(study.answer());
  }
  state.counters["impacts/s"] = per_iteration(1.0);
}
BENCHMARK(impact_to_answer)->Unit(benchmark::kMillisecond);

/// The equilibrium of the default contact, without the lattice.
void static_solution(benchmark::State& state) {
  Scene scene;
  scene.kind = SceneKind::kContact;
  scene.disk.recipe.points = static_cast<int>(state.range(0));
  const auto start = compose_shared(scene);
  double iterations = 0.0;
  for (auto _ : state) {
    Run run(scene, start);
    run.advance();
    iterations += static_cast<double>(run.state().step);
  }
  state.counters["iterations"] = Counter(iterations, Counter::kAvgIterations);
  state.counters["points*iterations/s"] = in_all(iterations * static_cast<double>(state.range(0)));
}
BENCHMARK(static_solution)->Arg(1099)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

/// Eight loads on one disk, by searches one after another or side by side.
template <class Solver>
void static_series(benchmark::State& state) {
  Scene scene;
  scene.kind = SceneKind::kContact;
  scene.disk.recipe.points = static_cast<int>(state.range(0));
  const auto bodies = make_bodies(scene);
  std::vector<Composition> starts;
  for (int i = 1; i <= kLanes; ++i) {
    scene.load.p = 0.001 * i;
    starts.push_back(compose(scene, bodies));
  }
  for (auto _ : state) {
    Solver solver;
    for (std::size_t first = 0; first < starts.size(); first += Solver::kSearches) {
      std::vector<std::unique_ptr<EquilibriumSearch>> searches;
      typename Solver::Searches lanes{};
      for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
        searches.push_back(make_search(scene, starts[first + lane]));
        lanes[lane] = searches.back().get();
      }
      const auto goes_on = [](const auto& search) { return !search->finished(); };
      while (std::any_of(searches.begin(), searches.end(), goes_on)) solver.advance(lanes);
    }
  }
  state.counters["solutions/s"] = per_iteration(kLanes);
}
BENCHMARK_TEMPLATE(static_series, EquilibriumSolver)
    ->Arg(1099)
    ->Arg(4000)
    ->Arg(16000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(static_series, LaneEquilibriumSolver)
    ->Arg(1099)
    ->Arg(4000)
    ->Arg(16000)
    ->Unit(benchmark::kMillisecond);

/// 16 velocities on one lattice.
std::vector<Scene> sixteen_velocities(const Scene& scene) {
  std::vector<Scene> scenes(16, scene);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    scenes[i].impact.velocity = 0.01 + 0.002 * static_cast<double>(i);
  }
  return scenes;
}

std::vector<Row> run_anew(const std::vector<Scene>& scenes, int jobs) {
  const auto file = std::filesystem::temp_directory_path() / "bench_runs.csv";
  std::filesystem::remove(file);
  const std::vector<Row> rows = run_series(scenes, file, {jobs});
  std::filesystem::remove(file);
  return rows;
}

/// By velocity Verlet with one step for all. Counted are the forces of each run: one evaluation a
/// step and one at the start.
void sweep_of_given_step(benchmark::State& state) {
  Scene scene;
  scene.numerics.integrator = IntegratorKind::kVerlet;
  scene.numerics.step = 0.01;
  double evaluations = 0.0;
  for (auto _ : state) {
    for (const Row& row : run_anew(sixteen_velocities(scene), static_cast<int>(state.range(0)))) {
      evaluations += 1.0 + row.results.at("steps");
    }
  }
  state.counters["bonds/s"] = in_all(evaluations * bonds_of(scene));
}

/// To the default error.
void sweep_to_answer(benchmark::State& state) {
  const std::vector<Scene> scenes = sixteen_velocities({});
  for (auto _ : state) run_anew(scenes, static_cast<int>(state.range(0)));
  state.counters["impacts/s"] = per_iteration(static_cast<double>(scenes.size()));
}

void jobs(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("jobs")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK(sweep_of_given_step)->Apply(jobs);
BENCHMARK(sweep_to_answer)->Apply(jobs);

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
