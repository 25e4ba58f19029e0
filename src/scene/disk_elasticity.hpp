#pragma once

#include <limits>
#include <optional>
#include <string>

#include "scene/scene.hpp"

namespace impact {

/// Elastic constants that a user knows better; empty: auto.
struct ElasticParameters {
  static constexpr double kHighestModulus = 1e6;  // M c²/R²
  static constexpr double kHighestRatio = 0.99;   // 1 would be incompressible, with b = 0
  std::optional<double> young_modulus;            ///< M c²/R²
  std::optional<double> poisson_ratio;
};

struct ElasticConstant {
  double value = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not known
  std::string origin;
};

struct DiskElasticity {
  ElasticConstant young_modulus;  ///< E, M c²/R², in plane stress
  ElasticConstant poisson_ratio;  ///< ν, in plane stress
};

/// The constants of the scene's lattice: those given, otherwise those measured on its recipe. Those
/// of a lattice from a file are not known unless given.
DiskElasticity disk_elasticity(const Scene& scene, const ElasticParameters& given);

}  // namespace impact
