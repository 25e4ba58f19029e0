#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "fits/law_fit.hpp"
#include "output/progress_bar.hpp"
#include "output/table.hpp"
#include "verification/work_precision.hpp"

namespace impact {
namespace {

constexpr double kError = 1e-5;  // far below what the lattice makes

/// So many lattices of so many points.
struct Size {
  int points;
  int lattices;
};

std::vector<Size> sizes(bool quick) {
  if (quick) return {{30, 3}, {60, 2}};
  return {{100, 128}, {300, 64}, {1000, 32}, {3000, 16}, {10000, 12}, {30000, 8}};
}

/// η* that gives a bond the same η, and so the material the same viscosity, as on the default disk.
double scaled_eta(double eta, int points) { return eta * points / Scene{}.disk.recipe.points; }

/// e and times of the lattices of one size.
struct SizeSample {
  int points;
  std::vector<double> restitution;
  std::vector<double> time;
};

SizeSample sample(double eta, const Size& size, double longest) {
  const std::string name = fmt::format("work_precision: eta* = {:g}, N = {}", eta, size.points);
  ProgressBar bar(name, static_cast<std::size_t>(size.lattices), "lattices");
  SizeSample sample{size.points, {}, {}};
  Scene scene;
  scene.impact.velocity = 0.05;
  scene.numerics.error = kError;
  scene.output.period = 1e6;  // R/c: no output
  scene.disk.recipe.points = size.points;
  scene.material.eta = scaled_eta(eta, size.points);
  for (int seed = 1; seed <= size.lattices; ++seed) {
    throw_if_interrupted();
    bar.show(sample.restitution.size());
    scene.seed = static_cast<std::uint64_t>(seed);
    TimedScene one(scene, Until::kAnswer);
    one.run(longest);
    if (!one.has_answer()) throw std::runtime_error(one.outcome().flags);
    sample.restitution.push_back(one.outcome().answer);
    sample.time.push_back(one.median_time());
  }
  return sample;
}

void add_lines(double eta, const std::vector<SizeSample>& samples, Table& table) {
  const MeanPoint finest = mean_point(0.0, samples.back().restitution);
  for (const SizeSample& one : samples) {
    const MeanPoint mean = mean_point(0.0, one.restitution);
    const auto lattices = static_cast<double>(mean.runs);
    const double scatter = mean.standard_error * std::sqrt(lattices);
    const bool is_finest = one.points == samples.back().points;
    const double time = median(one.time);
    table << eta << scaled_eta(eta, one.points) << static_cast<double>(one.points) << lattices
          << mean.y << mean.standard_error << scatter
          << (is_finest ? LawFit::kNaN : mean.y - finest.y)
          << std::hypot(mean.standard_error, finest.standard_error) << time;
    fmt::print("eta* = {:g}  N = {}  e = {:.5f} +- {:.5f}  one lattice +- {:.5f}  {:.3f} s\n",
               scaled_eta(eta, one.points), one.points, mean.y, mean.standard_error, scatter, time);
  }
}

}  // namespace

void measure_discretisation(const WorkPrecision& task) {
  constexpr double kLongest = 100.0;  // s
  Table table({"eta_of_1099_points", "eta", "points", "lattices", "restitution",
               "restitution_error", "scatter", "difference", "difference_error", "time"});
  fmt::print("\nDiscretisation, v = 0.05 c\n");
  for (const double eta : {0.0, 100.0}) {
    std::vector<SizeSample> samples;
    for (const Size& size : sizes(task.quick)) samples.push_back(sample(eta, size, kLongest));
    add_lines(eta, samples, table);
  }
  table.write(task.folder / "discretisation.csv");
}

}  // namespace impact
