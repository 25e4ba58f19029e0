// How long a lattice takes to build, and how the order in which its points are stored changes the
// time of a force evaluation.

#include <benchmark/benchmark.h>

#include "lattice/lattice.hpp"
#include "lattice/placement.hpp"
#include "lattice/triangulation.hpp"
#include "mechanics/bond_forces.hpp"

namespace impact {
namespace {

PointArray disk_points(int count) { return place_in_disk({count}, 1); }

Lattice in_given_order(const PointArray& points) {
  return make_lattice(points, delaunay_bonds(points));
}

Lattice in_random_order(const PointArray& points) { return in_given_order(points); }

Lattice in_hilbert_order(const PointArray& points) {
  return in_given_order(points(hilbert_order(points), Eigen::all));
}

Lattice in_storage_order(const PointArray& points) { return triangulated_lattice(points); }

using Order = Lattice (*)(const PointArray&);

template <Order kOrder>
void force_evaluation(benchmark::State& state) {
  const Lattice lattice = kOrder(disk_points(static_cast<int>(state.range(0))));
  BondForces bonds(lattice, {1.0, 1e-3, 0.0});
  const PointArray velocity = PointArray::Zero(lattice.points.rows(), 2);
  PointArray force(lattice.points.rows(), 2);
  for (auto _ : state) {
    bonds.evaluate(lattice.points, velocity, force);
    benchmark::DoNotOptimize(force.data());
  }
  state.counters["bonds/s"] = benchmark::Counter(static_cast<double>(lattice.bonds.size()),
                                                 benchmark::Counter::kIsIterationInvariantRate);
}

void construction(benchmark::State& state) {
  for (auto _ : state) {
    const Lattice lattice = triangulated_lattice(disk_points(static_cast<int>(state.range(0))));
    benchmark::DoNotOptimize(lattice.bonds.data());
  }
  state.counters["points/s"] = benchmark::Counter(static_cast<double>(state.range(0)),
                                                  benchmark::Counter::kIsIterationInvariantRate);
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(1099)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMicrosecond);
}

BENCHMARK(force_evaluation<in_random_order>)->Apply(sizes);
BENCHMARK(force_evaluation<in_hilbert_order>)->Apply(sizes);
BENCHMARK(force_evaluation<in_storage_order>)->Apply(sizes);
BENCHMARK(construction)->Apply(sizes);

}  // namespace
}  // namespace impact

BENCHMARK_MAIN();
