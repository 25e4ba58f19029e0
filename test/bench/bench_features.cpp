// What each feature of a scene costs: the time of 64 steps with and without it, for the disk at
// the wall. The default scene is the collision with cubic springs, without damping, at the
// potential wall; onlookers are what a run adds to the steps themselves.

#include <benchmark/benchmark.h>

#include <map>
#include <optional>
#include <utility>

#include "mechanics/simulation.hpp"
#include "run/compose.hpp"
#include "run/contact_recorder.hpp"
#include "run/energy_monitor.hpp"
#include "statics/folding.hpp"

namespace impact {
namespace {

constexpr int kSteps = 64;  // so often a run looks at its energy and its triangles

/// The default collision of this many points, its lowest at the wall: 5 % of the points are within
/// reach of the repulsion, 0.2 R.
Scene touching(int points) {
  Scene scene;
  scene.disk.recipe.points = points;
  scene.wall.points = static_cast<int>(1269.0 / 1099.0 * points);
  scene.impact.gap = 0.0;
  scene.numerics.integrator = IntegratorKind::kVerlet;
  return scene;
}

Scene above(Scene scene) {
  scene.impact.gap = 1.0;
  return scene;
}

Scene on_lattice(int points, Boundary boundary) {
  Scene scene = touching(points);
  scene.wall.kind = WallKind::kLattice;
  scene.wall.boundary = boundary;
  return scene;
}

Composition springs(int points, double k_b, double eta) {
  Scene scene = touching(points);
  scene.material.k_b = k_b;
  scene.material.eta = eta;
  return compose(scene);
}

Composition default_scene(int points) { return compose(touching(points)); }

Composition linear_springs(int points) { return springs(points, 0.0, 0.0); }
Composition linear_damped_springs(int points) { return springs(points, 0.0, 1.0); }
Composition cubic_damped_springs(int points) { return springs(points, 1e-3, 1.0); }

Composition without_wall(int points) {
  Composition composition = default_scene(points);
  composition.field.wall.reset();
  return composition;
}
Composition above_wall(int points) { return compose(above(touching(points))); }

Composition beside_clamped_lattice(int points) {
  Composition composition = compose(on_lattice(points, Boundary::kFixed));
  composition.field.elastic_wall.reset();
  return composition;
}
Composition above_clamped_lattice(int points) {
  return compose(above(on_lattice(points, Boundary::kFixed)));
}
Composition at_clamped_lattice(int points) { return compose(on_lattice(points, Boundary::kFixed)); }
Composition at_lattice_with_resets(int points) {
  return compose(on_lattice(points, Boundary::kReset));
}
Composition at_lattice_with_dashpots(int points) {
  return compose(on_lattice(points, Boundary::kViscous));
}

/// What may look on while a simulation goes.
struct Nobody {
  explicit Nobody(const Composition& /*composition*/) {}
  void begin(const Simulation& /*start*/) {}
  void after_step(const Simulation& /*simulation*/) {}
  void at_end(const Simulation& /*simulation*/) {}
};

struct Energy : Nobody {
  using Nobody::Nobody;
  void begin(const Simulation& start) { monitor.emplace(start.ledger()); }
  void at_end(const Simulation& simulation) { monitor->check(simulation); }
  std::optional<EnergyMonitor> monitor;
};

struct Folds : Nobody {
  explicit Folds(const Composition& composition)
      : Nobody(composition), triangles(composition.bodies->disk()) {}
  void at_end(const Simulation& simulation) {
    benchmark::DoNotOptimize(triangles.turned_over(simulation.state().position));
  }
  Triangles triangles;
};

struct Contact : Nobody {
  using Nobody::Nobody;
  void begin(const Simulation& start) { recorder.emplace(start, 1e-8); }
  void after_step(const Simulation& simulation) {
    recorder->add_step(simulation);
    if (simulation.state().step % 2 == 0) benchmark::DoNotOptimize(recorder->take(simulation));
  }
  std::optional<ContactRecorder> recorder;
};

using Start = Composition (*)(int points);

/// Made once for all repetitions.
const Composition& composed(Start start, int points) {
  static std::map<std::pair<Start, int>, Composition> made;
  const auto found = made.find({start, points});
  if (found != made.end()) return found->second;
  return made.emplace(std::pair(start, points), start(points)).first->second;
}

std::size_t bonds(const Composition& composition) {
  const std::size_t of_wall =
      composition.bodies->is_alone() ? 0 : composition.bodies->all[1].lattice.bonds.size();
  return composition.bodies->disk().bonds.size() + of_wall;
}

template <Start kStart, class Onlooker = Nobody>
void steps(benchmark::State& state) {
  const Composition& start = composed(kStart, static_cast<int>(state.range(0)));
  Onlooker onlooker(start);
  for (auto _ : state) {
    state.PauseTiming();
    Simulation simulation(start.field, start.initial, start.rates.lattice, start.resolution.step);
    onlooker.begin(simulation);
    state.ResumeTiming();
    for (int step = 0; step < kSteps; ++step) {
      simulation.step();
      onlooker.after_step(simulation);
    }
    onlooker.at_end(simulation);
  }
  using benchmark::Counter;
  state.counters["steps/s"] = Counter(kSteps, Counter::kIsIterationInvariantRate);
  state.counters["bonds/s"] =
      Counter(static_cast<double>(kSteps * bonds(start)), Counter::kIsIterationInvariantRate);
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(1099)->Arg(30000)->Unit(benchmark::kMicrosecond);
}

BENCHMARK(steps<default_scene>)->Apply(sizes);

BENCHMARK(steps<linear_springs>)->Apply(sizes);
BENCHMARK(steps<linear_damped_springs>)->Apply(sizes);
BENCHMARK(steps<cubic_damped_springs>)->Apply(sizes);

BENCHMARK(steps<without_wall>)->Apply(sizes);
BENCHMARK(steps<above_wall>)->Apply(sizes);

BENCHMARK(steps<beside_clamped_lattice>)->Apply(sizes);
BENCHMARK(steps<above_clamped_lattice>)->Apply(sizes);
BENCHMARK(steps<at_clamped_lattice>)->Apply(sizes);
BENCHMARK(steps<at_lattice_with_resets>)->Apply(sizes);
BENCHMARK(steps<at_lattice_with_dashpots>)->Apply(sizes);

BENCHMARK(steps<default_scene, Energy>)->Apply(sizes);
BENCHMARK(steps<default_scene, Folds>)->Apply(sizes);
BENCHMARK(steps<default_scene, Contact>)->Apply(sizes);

}  // namespace
}  // namespace impact

BENCHMARK_MAIN();
