#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "fits/fits.hpp"
#include "fits/statistics.hpp"
#include "theory/hertz.hpp"

namespace impact {

/// A law of the paper against measured points: theory without free parameters, and the fit. What is
/// not known is NaN.
struct LawFit {
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  struct Parameter {
    std::string name;
    Estimate estimate{kNaN, kNaN};
    double paper = kNaN;  ///< what the paper fits in the same scene
  };

  std::string law;
  std::vector<MeanPoint> points;
  std::vector<double> theory;         ///< at each point
  std::vector<double> inertial_load;  ///< at each point: inertial_load_compression()
  std::vector<Parameter> parameters;
  Fit fit;
};

/// `hertz`: points (P, ξ) against eq. (2) with b = 1 − ν², and b fitted, each point weighted by its
/// number of runs. Declined when a constant of the disk is NaN.
LawFit hertz_law_fit(const std::vector<MeanPoint>& points, const ElasticDisk& disk);

/// `restitution`: points (v/c_s, e) against eq. (4), stopped at ξ = 0, with E* = E and this
/// dissipation time (R/c), and d₁, d₂ of eq. (5) fitted, each point weighted by its number of runs.
/// Declined when Young's modulus is NaN. The theory is NaN for v ≥ c_s, which is not quasi-static.
/// `paper`: d₁ and d₂ of the paper's fit in this scene, if it gives them.
LawFit restitution_law_fit(const std::vector<MeanPoint>& points, double young_modulus,
                           double dissipation_time,
                           const std::array<double, 2>& paper = {LawFit::kNaN, LawFit::kNaN});

/// b of the paper's figure 2.
constexpr double kPaperHertzFactor = 1.55;

/// d₁ and d₂ of the paper's figure 6, the absorbing wall.
constexpr std::array<double, 2> kPaperAbsorbingWall{0.973, 0.119};

}  // namespace impact
