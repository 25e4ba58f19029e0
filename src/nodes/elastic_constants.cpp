#include "nodes/elastic_constants.hpp"

#include <fmt/format.h>

namespace impact {
namespace {

/// Measured on periodic lattices without a rim, of springs of equal k_a.
struct PeriodicBulk {
  const char* placement;
  double young_modulus_by_k_a;
  double poisson_ratio;
};

constexpr PeriodicBulk kUniform{"uniform", 1.04, 0.265};        // ± 0.01, ± 0.004
constexpr PeriodicBulk kBlueNoise{"blue noise", 1.085, 0.275};  // ± 0.002, ± 0.002

ElasticConstants measured(const Scene& scene) {
  if (!scene.disk.file.empty()) {
    ElasticConstants unknown;
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

ElasticConstants elastic_constants(const Scene& scene, const ElasticParameters& given) {
  ElasticConstants constants = measured(scene);
  if (given.young_modulus) {
    constants.young_modulus = {*given.young_modulus, "parameter young_modulus"};
  }
  if (given.poisson_ratio) {
    constants.poisson_ratio = {*given.poisson_ratio, "parameter poisson_ratio"};
  }
  return constants;
}

}  // namespace impact
