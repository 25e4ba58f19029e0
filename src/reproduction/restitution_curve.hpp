#pragma once

#include <string>
#include <vector>

#include "output/table.hpp"
#include "reproduction/ensemble.hpp"
#include "theory/hertz.hpp"

namespace impact {

/// The scene at ten speeds of figures 3 and 6, from 3·10⁻³ to 5·10⁻² c, about evenly in log v.
std::vector<Scene> at_all_speeds(const Scene& scene);

double speed_of(const Scene& scene);

/// For the fits of add_fits().
Table fit_table();

/// Adds the fits of (d₁, d₂) of eq. (5) to the mean curve e(v): over all speeds and over those at
/// which the wall's range no longer counts, v ≥ 0.01 c; with c_s, as in the theory, and with c, as
/// the paper writes, as the speed under the logarithm.
void add_fits(const std::string& name, const Ensemble& curves, const ElasticDisk& disk,
              Table& table);

/// Eq. (5) at each speed, with the parameters of the fit of all speeds with c_s; NaN when it is
/// declined.
std::vector<double> fitted_curve(const Ensemble& curves, const ElasticDisk& disk);

}  // namespace impact
