#include "scene/disk_elasticity.hpp"

#include <fmt/format.h>

namespace impact {
namespace {

/// Measured on periodic lattices of 4000 points without a rim, of springs of equal k_a (the
/// periodic patches of doc/report.md).
struct PeriodicBulk {
  const char* placement;
  double young_modulus_by_k_a;
  double poisson_ratio;
};

constexpr PeriodicBulk kUniform{"uniform", 1.042, 0.264};       // ± 0.001, ± 0.001
constexpr PeriodicBulk kBlueNoise{"blue noise", 1.082, 0.276};  // ± 0.001, ± 0.001

DiskElasticity measured(const Scene& scene) {
  if (!scene.disk.file.empty()) {
    DiskElasticity unknown;
    unknown.young_modulus.origin = unknown.poisson_ratio.origin = "not known: lattice from a file";
    return unknown;
  }
  const PeriodicBulk& bulk =
      scene.disk.recipe.placement == Placement::kUniform ? kUniform : kBlueNoise;
  return {{bulk.young_modulus_by_k_a * scene.material.k_a,
           fmt::format("{} k_a, periodic bulk of {} placement", bulk.young_modulus_by_k_a,
                       bulk.placement)},
          {bulk.poisson_ratio, fmt::format("periodic bulk of {} placement", bulk.placement)}};
}

}  // namespace

DiskElasticity disk_elasticity(const Scene& scene, const ElasticParameters& given) {
  DiskElasticity constants = measured(scene);
  if (given.young_modulus) {
    constants.young_modulus = {*given.young_modulus, "parameter young_modulus"};
  }
  if (given.poisson_ratio) {
    constants.poisson_ratio = {*given.poisson_ratio, "parameter poisson_ratio"};
  }
  return constants;
}

}  // namespace impact
