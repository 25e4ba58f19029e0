#include <fmt/format.h>

#include <algorithm>

#include "fits/law_fit.hpp"
#include "output/table.hpp"
#include "reproduction/ensemble.hpp"
#include "reproduction/reproduction.hpp"
#include "reproduction/restitution_curve.hpp"
#include "theory/quasi_static.hpp"

namespace impact {
namespace {

struct WallCase {
  std::string name;
  Scene scene;
};

Scene on_elastic_wall(Boundary boundary) {
  Scene scene;
  scene.wall.kind = WallKind::kLattice;
  scene.wall.boundary = boundary;
  return scene;
}

std::vector<WallCase> wall_cases() {
  std::vector<WallCase> all;
  for (const double interval : {0.004, 0.001, 0.002, 0.008, 0.016}) {
    all.push_back({fmt::format("reset {}", interval), on_elastic_wall(Boundary::kReset)});
    all.back().scene.wall.reset_interval = interval;
  }
  all.push_back({"fixed", on_elastic_wall(Boundary::kFixed)});
  all.push_back({"viscous", on_elastic_wall(Boundary::kViscous)});
  all.push_back({"reset 0.004 vertical gap", on_elastic_wall(Boundary::kReset)});
  all.back().scene.wall.gap = GapMeasure::kVertical;
  all.push_back({"reset 0.004 uniform placement", on_elastic_wall(Boundary::kReset)});
  all.back().scene.disk.recipe.placement = Placement::kUniform;
  return all;
}

double largest(const Ensemble& curves, std::size_t place) {
  double value = 0.0;
  for (const std::vector<double>& curve : curves.y) value = std::max(value, curve[place]);
  return value;
}

void add_lines(const WallCase& one, const Ensemble& curves, const Ensemble& hops,
               const ElasticDisk& disk, Table& table) {
  const double c = sound_speed(disk.young_modulus);
  const std::vector<MeanPoint> curve = mean_curve(curves);
  const std::vector<MeanPoint> mean_hops = mean_curve(hops);
  const std::vector<double> fitted = fitted_curve(curves, disk);
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const MeanPoint& point = curve[k];
    const double energy = 0.5 * point.x * point.x;
    table << one.name << point.x << point.x / c << fmt::format("{}", point.runs) << point.y
          << point.standard_error << fitted[k]
          << closed_form_restitution(kPaperAbsorbingWall[0], kPaperAbsorbingWall[1], point.x)
          << mean_hops[k].y / energy << largest(hops, k) / energy;
  }
}

}  // namespace

std::vector<Scene> scenes_of_figure6(int lattices) {
  std::vector<Scene> scenes;
  for (const WallCase& one : wall_cases()) {
    for (const Scene& scene : at_all_speeds(one.scene)) scenes.push_back(scene);
  }
  return with_seeds(scenes, lattices);
}

void reproduce_figure6(const Reproduction& reproduction, const Material& material) {
  const std::vector<WallCase> all = wall_cases();
  const std::vector<Row> rows =
      simulate(reproduction, "figure6", scenes_of_figure6(reproduction.lattices));

  Table table({"case", "velocity", "velocity_by_sound_speed", "lattices", "restitution",
               "restitution_error", "fit", "paper_fit", "hops_by_impact_energy",
               "largest_hops_by_impact_energy"});
  Table fits = fit_table();
  const std::size_t speeds = at_all_speeds({}).size();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::vector<Row> rows_of_case = every(rows, k * speeds, speeds, all.size() * speeds);
    const Ensemble curves = ensemble(rows_of_case, speed_of, "restitution");
    const ElasticDisk& disk = material.of(all[k].scene.disk.recipe.placement);
    add_lines(all[k], curves, ensemble(rows_of_case, speed_of, "hops"), disk, table);
    add_fits(all[k].name, curves, disk, fits);
  }
  table.write(reproduction.folder / "figure6.csv");
  fits.write(reproduction.folder / "figure6_fits.csv");
}

}  // namespace impact
