#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fits/law_fit.hpp"
#include "series/series_file.hpp"

namespace impact {

/// One curve y(x) for each lattice of an ensemble, all at the same x.
struct Ensemble {
  std::vector<double> x;               ///< rising
  std::vector<std::vector<double>> y;  ///< by lattice, then by x
};

/// The names of the flags of a run.
std::vector<std::string> flags_of(const Row& row);

/// The curves of one result over one abscissa, one for each seed. A lattice of which a run has no
/// sound answer (is_sound()) is left out.
Ensemble ensemble(const std::vector<Row>& rows, const std::function<double(const Scene&)>& abscissa,
                  const std::string& result);

/// Of rows that come in blocks of `block`, one for each seed: those from `first` on, `count` of
/// each block.
std::vector<Row> every(const std::vector<Row>& rows, std::size_t first, std::size_t count,
                       std::size_t block);

/// Mean over the lattices at each x, and its standard error.
std::vector<MeanPoint> mean_curve(const Ensemble& ensemble);

/// The part of the ensemble with x ≥ `low`.
Ensemble above(const Ensemble& ensemble, double low);

/// A fit and how much it owes to the choice of lattices.
struct EnsembleFit {
  Fit fit;                             ///< standard errors from the scatter about the law
  std::vector<double> sampling_error;  ///< of each parameter, from the choice of lattices
};

/// The fit of a law to the mean curve, all points with equal weight.
Fit fit_mean(const Ensemble& ensemble,
             const std::function<Fit(const std::vector<DataPoint>&)>& fit);

/// fit_mean(); the sampling errors are the jackknife's (B. Efron and C. Stein, Ann. Stat.
/// 9 (1981) 586), see jackknife_error(), with θ_i the fit without lattice i; NaN when one of
/// those is declined or there are fewer than two lattices.
EnsembleFit fit_ensemble(const Ensemble& ensemble,
                         const std::function<Fit(const std::vector<DataPoint>&)>& fit);

}  // namespace impact
