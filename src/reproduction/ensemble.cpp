#include "reproduction/ensemble.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include "measure/flags.hpp"

namespace impact {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<DataPoint> points_of(const Ensemble& ensemble) {
  std::vector<DataPoint> points;
  for (const MeanPoint& point : mean_curve(ensemble)) points.push_back({point.x, point.y, 1.0});
  return points;
}

Ensemble without(const Ensemble& ensemble, std::size_t lattice) {
  Ensemble others = ensemble;
  others.y.erase(others.y.begin() + static_cast<std::ptrdiff_t>(lattice));
  return others;
}

}  // namespace

std::vector<std::string> flags_of(const Row& row) {
  std::vector<std::string> flags;
  std::istringstream text(row.flags);
  for (std::string flag; std::getline(text, flag, ';');) flags.push_back(flag);
  return flags;
}

Ensemble ensemble(const std::vector<Row>& rows, const std::function<double(const Scene&)>& abscissa,
                  const std::string& result) {
  std::set<double> places;
  std::map<std::uint64_t, std::map<double, double>> curves;
  for (const Row& row : rows) {
    const double x = abscissa(row.scene);
    places.insert(x);
    if (is_sound(flags_of(row))) curves[row.scene.seed][x] = row.results.at(result);
  }
  Ensemble all{{places.begin(), places.end()}, {}};
  for (const auto& [seed, curve] : curves) {
    if (curve.size() != places.size()) continue;
    std::vector<double>& values = all.y.emplace_back();
    for (const auto& [x, y] : curve) values.push_back(y);
  }
  return all;
}

std::vector<Row> every(const std::vector<Row>& rows, std::size_t first, std::size_t count,
                       std::size_t block) {
  std::vector<Row> chosen;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t place = i % block;
    if (place >= first && place < first + count) chosen.push_back(rows[i]);
  }
  return chosen;
}

std::vector<MeanPoint> mean_curve(const Ensemble& ensemble) {
  std::vector<MeanPoint> points;
  for (std::size_t k = 0; k < ensemble.x.size(); ++k) {
    std::vector<double> values;
    for (const std::vector<double>& curve : ensemble.y) values.push_back(curve[k]);
    points.push_back(values.empty() ? MeanPoint{ensemble.x[k], kNaN, kNaN, 0}
                                    : mean_point(ensemble.x[k], values));
  }
  return points;
}

Ensemble above(const Ensemble& ensemble, double low) {
  const auto first = std::lower_bound(ensemble.x.begin(), ensemble.x.end(), low);
  const auto skipped = first - ensemble.x.begin();
  Ensemble part{{first, ensemble.x.end()}, {}};
  for (const std::vector<double>& curve : ensemble.y) {
    part.y.emplace_back(curve.begin() + skipped, curve.end());
  }
  return part;
}

Fit fit_mean(const Ensemble& ensemble,
             const std::function<Fit(const std::vector<DataPoint>&)>& fit) {
  return fit(points_of(ensemble));
}

EnsembleFit fit_ensemble(const Ensemble& ensemble,
                         const std::function<Fit(const std::vector<DataPoint>&)>& fit) {
  EnsembleFit result{fit(points_of(ensemble)), {}};
  const std::size_t parameters = result.fit.parameters.size();
  const std::size_t lattices = ensemble.y.size();
  result.sampling_error.assign(parameters, kNaN);
  if (lattices < 2) return result;
  std::vector<std::vector<double>> estimates(parameters);
  for (std::size_t i = 0; i < lattices; ++i) {
    const Fit others = fit(points_of(without(ensemble, i)));
    if (!others.declined.empty()) return result;
    for (std::size_t k = 0; k < parameters; ++k) {
      estimates[k].push_back(others.parameters[k].value);
    }
  }
  for (std::size_t k = 0; k < parameters; ++k) {
    result.sampling_error[k] = jackknife_error(estimates[k]);
  }
  return result;
}

}  // namespace impact
