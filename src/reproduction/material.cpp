#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "fits/law_fit.hpp"
#include "lattice/periodic_patch.hpp"
#include "measure/elastic_constants.hpp"
#include "output/progress_bar.hpp"
#include "output/table.hpp"
#include "reproduction/reproduction.hpp"

namespace impact {
namespace {

constexpr int kRectangles = 200;
constexpr int kPatches = 40;
constexpr int kPatchPoints = 4000;

const char* name(Placement placement) {
  return placement == Placement::kUniform ? "uniform" : "blue_noise";
}

void add_line(Table& table, const std::string& method, Placement placement,
              const std::vector<double>& moduli, const std::vector<double>& ratios) {
  const MeanPoint e = mean_point(0.0, moduli);
  const MeanPoint nu = mean_point(0.0, ratios);
  table << method << name(placement) << fmt::format("{}", moduli.size()) << e.y << e.standard_error
        << nu.y << nu.standard_error << std::sqrt(M_PI * e.y);
}

void measure_patches(Placement placement, Table& table) {
  std::vector<double> moduli;
  std::vector<double> ratios;
  ProgressBar bar("reproduce: periodic patches", kPatches, "patches");
  for (int seed = 1; seed <= kPatches; ++seed) {
    bar.show(moduli.size());
    break_off_if_interrupted();
    const PeriodicPatch patch =
        random_patch(kPatchPoints, placement, 1.0, 1.0, static_cast<std::uint64_t>(seed));
    const ElasticConstants constants = isotropic_average(periodic_stiffness(patch, 1.0));
    moduli.push_back(constants.young_modulus);
    ratios.push_back(constants.poisson_ratio);
  }
  add_line(table, "periodic patch", placement, moduli, ratios);
}

ElasticDisk measure_rectangles(const std::vector<Row>& rows, Placement placement, Table& table) {
  std::vector<double> moduli;
  std::vector<double> ratios;
  std::vector<double> of_grips;
  for (const Row& row : rows) {
    if (row.scene.disk.recipe.placement != placement || !row.flags.empty()) continue;
    moduli.push_back(row.results.at("young_modulus"));
    ratios.push_back(row.results.at("poisson_ratio"));
    of_grips.push_back(row.results.at("grip_modulus"));
  }
  if (moduli.empty()) throw std::runtime_error("no rectangle came to rest");
  add_line(table, "stretched rectangle", placement, moduli, ratios);
  add_line(table, "stretched rectangle with its rim", placement, of_grips, ratios);
  return {mean_point(0.0, moduli).y, mean_point(0.0, ratios).y};
}

}  // namespace

Material measure_material(const Reproduction& reproduction) {
  std::vector<Scene> scenes(2);
  for (Scene& scene : scenes) scene.kind = SceneKind::kStretch;
  scenes[1].disk.recipe.placement = Placement::kUniform;
  const std::vector<Row> rows = simulate(reproduction, "material", with_seeds(scenes, kRectangles));

  Table table({"method", "placement", "lattices", "young_modulus", "young_modulus_error",
               "poisson_ratio", "poisson_ratio_error", "sound_speed"});
  const Material material{measure_rectangles(rows, Placement::kBlueNoise, table),
                          measure_rectangles(rows, Placement::kUniform, table)};
  measure_patches(Placement::kBlueNoise, table);
  measure_patches(Placement::kUniform, table);
  table.write(reproduction.folder / "material.csv");
  return material;
}

}  // namespace impact
