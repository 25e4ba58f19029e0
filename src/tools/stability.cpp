// The stiff and the extreme: what `auto` makes of scenes far from the default, and whether the
// error that it states holds.

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "output/interruption.hpp"
#include "output/output_folder.hpp"
#include "output/program.hpp"
#include "output/progress_bar.hpp"
#include "output/table.hpp"
#include "series/series.hpp"

namespace impact {
namespace {

constexpr double kError = 1e-4;
constexpr double kReferenceError = 1e-6;

/// A scene that is extreme in some way.
struct Case {
  std::string name;
  Scene scene;
};

using Change = std::function<void(Scene&, double)>;

void add(std::vector<Case>& cases, const std::string& name, const Scene& base,
         const std::vector<double>& values, const Change& change) {
  for (const double value : values) {
    Scene scene = base;
    change(scene, value);
    cases.push_back({fmt::format("{} = {:g}", name, value), scene});
  }
}

Scene contact() {
  Scene scene;
  scene.kind = SceneKind::kContact;
  return scene;
}

Scene absorbing_wall() {
  Scene scene;
  scene.wall.kind = WallKind::kLattice;
  return scene;
}

void add_materials(std::vector<Case>& cases) {
  const Scene collision;
  const Change eta = [](Scene& s, double value) { s.material.eta = value; };
  add(cases, "η*", collision, {0, 1, 100, 1e4, 1e6}, eta);
  add(cases, "v = 1, η*", collision, {1e3, 1e6}, [&](Scene& s, double value) {
    s.impact.velocity = 1.0;
    s.material.eta = value;
  });
  const Change k_b = [](Scene& s, double value) { s.material.k_b = value; };
  add(cases, "k_b", collision, {0, 1, 1e3, 1e6}, k_b);
  add(cases, "v = 1, k_b", collision, {1e6}, [&](Scene& s, double value) {
    s.impact.velocity = 1.0;
    s.material.k_b = value;
  });
}

void add_impacts(std::vector<Case>& cases) {
  const Change v = [](Scene& s, double value) { s.impact.velocity = value; };
  add(cases, "v", Scene{}, {1e-5, 1e-3, 0.1, 0.2, 0.5, 1}, v);
  Scene uniform;
  uniform.disk.recipe.placement = Placement::kUniform;
  add(cases, "uniform, v", uniform, {0.01, 0.1, 0.3}, v);
  add(cases, "absorbing wall, v", absorbing_wall(), {1e-3, 0.1, 0.5}, v);
}

void add_walls(std::vector<Case>& cases) {
  add(cases, "a", Scene{}, {30, 3e3, 1e5}, [](Scene& s, double value) { s.wall.a = value; });
  add(cases, "absorbing wall, reset interval", absorbing_wall(), {1, 0.01, 1e-3, 1e-4},
      [](Scene& s, double value) { s.wall.reset_interval = value; });
  for (const auto& [name, boundary] :
       {std::make_pair("fixed", Boundary::kFixed), std::make_pair("viscous", Boundary::kViscous)}) {
    Scene scene = absorbing_wall();
    scene.wall.boundary = boundary;
    cases.push_back({fmt::format("absorbing wall, {}", name), scene});
  }
}

void add_contacts(std::vector<Case>& cases) {
  const Change load = [](Scene& s, double value) { s.load.p = value; };
  add(cases, "contact, P", contact(), {1e-9, 4e-3, 0.01, 0.1, 0.3, 1}, load);
  Scene rolling = contact();
  rolling.load.hold_rotation = false;
  add(cases, "contact, rolling, P", rolling, {4e-3}, load);
}

void add_sizes(std::vector<Case>& cases, double largest) {
  std::vector<double> sizes{3, 30, 300, 1e4, 1e5, 1e6};
  sizes.erase(std::upper_bound(sizes.begin(), sizes.end(), largest), sizes.end());
  const Change points = [](Scene& s, double value) {
    s.disk.recipe.points = static_cast<int>(value);
  };
  Scene fast;
  fast.impact.velocity = 0.05;
  add(cases, "v = 0.05, N", fast, sizes, points);
  Scene small;
  small.impact.velocity = 1.0;
  small.material.eta = 1e6;
  add(cases, "v = 1, η* = 1e+06, N", small, {3}, points);
  add(cases, "contact, N", contact(), {3, 30, 1e4}, points);
}

std::vector<Case> all_cases(double largest) {
  std::vector<Case> cases;
  add_materials(cases);
  add_impacts(cases);
  add_walls(cases);
  add_contacts(cases);
  add_sizes(cases, largest);
  for (Case& one : cases) {
    one.scene.numerics.error = kError;
    one.scene.output.period = 1.0;
  }
  return cases;
}

/// Each case with the wanted error and, after it, its reference.
std::vector<Scene> with_references(const std::vector<Case>& cases) {
  std::vector<Scene> scenes;
  for (const Case& one : cases) {
    scenes.push_back(one.scene);
    scenes.push_back(one.scene);
    scenes.back().numerics.error = kReferenceError;
  }
  return scenes;
}

double answer(const Row& row) {
  return row.results.at(row.scene.kind == SceneKind::kContact ? "strain" : "restitution");
}

double true_error(const Row& row, const Row& reference) {
  return std::abs(answer(row) - answer(reference)) / std::abs(answer(reference));
}

/// Whether the answer is as good as it says. One that has a reference only.
bool holds(const Row& row, const Row& reference) {
  return has_failed(row) || has_failed(reference) || true_error(row, reference) <= kError;
}

void write_table(const std::vector<Case>& cases, const std::vector<Row>& rows,
                 const std::filesystem::path& file) {
  Table table({"case", "integrator", "answer [-]", "estimated error [-]", "true error [-]",
               "energy error [-]", "step [R/c]", "steps [-]", "time [s]", "said"});
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Row& row = rows[2 * i];
    table << cases[i].name << row.integrator;
    if (has_failed(row)) {
      for (int k = 0; k < 7; ++k) table << std::string{};
    } else {
      table << answer(row) << row.results.at("estimated_error") << true_error(row, rows[2 * i + 1])
            << row.results.at("energy_error") << row.results.at("step") << row.results.at("steps")
            << row.results.at("wall_time");
    }
    table << row.flags;
  }
  table.write(file);
}

void print(const std::vector<Case>& cases, const std::vector<Row>& rows) {
  fmt::print(
      "| case | integrator | step (R/c) | answer | estimated error | true error | "
      "energy error | time (s) | said |\n|---|---|---|---|---|---|---|---|---|\n");
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Row& row = rows[2 * i];
    const Row& reference = rows[2 * i + 1];
    if (has_failed(row)) {
      fmt::print("| {} | | | | | | | | {} |\n", cases[i].name, row.flags);
      continue;
    }
    const std::string error =
        has_failed(reference) ? "?" : fmt::format("{:.1e}", true_error(row, reference));
    fmt::print("| {} | {} | {:.3g} | {:.6g} | {:.1e} | {} | {:.0e} | {:.2g} | {} |\n",
               cases[i].name, row.integrator, row.results.at("step"), answer(row),
               row.results.at("estimated_error"), error, row.results.at("energy_error"),
               row.results.at("wall_time"), row.flags);
  }
}

void check_stability(const std::string& output, double largest, int jobs) {
  const OutputFolder folder(output);
  const std::vector<Case> cases = all_cases(largest);
  const std::vector<Scene> scenes = with_references(cases);
  take_interruptions();
  std::vector<Row> rows;
  {
    ProgressBar bar("stability", scenes.size());
    rows = run_series(
        scenes, folder.path() / "stability_runs.csv",
        {jobs, [&bar](std::size_t /*rows*/, std::size_t runs) { bar.show(runs); }, interrupted});
  }
  write_table(cases, rows, folder.path() / "stability.csv");
  print(cases, rows);
  int wrong = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!holds(rows[2 * i], rows[2 * i + 1])) ++wrong;
  }
  if (wrong > 0) throw std::runtime_error(fmt::format("{} answers err by more than stated", wrong));
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  CLI::App app(
      "Runs stiff and extreme scenes to an error of 1e-4 and checks the answers against runs to "
      "1e-6.",
      "stability");
  std::string output;
  double largest = 1e4;
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  app.add_option("--output", output, "folder for stability.csv and all runs; one is continued")
      ->required();
  app.add_option("--largest", largest, "number of points of the largest disk, up to 1e6")
      ->capture_default_str();
  app.add_option("--jobs", jobs, "threads")->capture_default_str()->check(CLI::Range(1, 1024));
  return impact::run_tool(app, argc, argv, [&] { impact::check_stability(output, largest, jobs); });
}
