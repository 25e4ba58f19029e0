#include "fits/law_fit.hpp"

#include <cmath>

#include "fits/quasi_static_impact.hpp"

namespace impact {
namespace {

std::vector<DataPoint> weighted_by_runs(const std::vector<MeanPoint>& points) {
  std::vector<DataPoint> data;
  data.reserve(points.size());
  for (const MeanPoint& point : points) {
    data.push_back({point.x, point.y, 1.0 / std::sqrt(static_cast<double>(point.runs))});
  }
  return data;
}

void set_fit(LawFit& law, const Fit& fit) {
  law.fit = fit;
  for (std::size_t k = 0; k < fit.parameters.size(); ++k) {
    law.parameters[k].estimate = fit.parameters[k];
  }
}

double quasi_static_theory(double young_modulus, double dissipation_time, double velocity) {
  const double c = sound_speed(young_modulus);
  if (std::isnan(dissipation_time) || !(velocity < c)) return LawFit::kNaN;
  return quasi_static_restitution({young_modulus, dissipation_time, velocity},
                                  EndOfImpact::kNoCompression, c);
}

}  // namespace

LawFit hertz_law_fit(const std::vector<MeanPoint>& points, const ElasticDisk& disk) {
  LawFit law;
  law.law = "hertz";
  law.points = points;
  law.parameters = {{"b", {LawFit::kNaN, LawFit::kNaN}, kPaperHertzFactor}};
  const double b = 1.0 - disk.poisson_ratio * disk.poisson_ratio;
  for (const MeanPoint& point : points) {
    law.theory.push_back(hertz_compression(disk, b, point.x));
    law.inertial_load.push_back(inertial_load_compression(disk, point.x));
  }
  const bool known = !std::isnan(disk.young_modulus) && !std::isnan(disk.poisson_ratio);
  set_fit(law, known ? fit_hertz(weighted_by_runs(points), disk)
                     : declined("young_modulus and poisson_ratio of this lattice are not known"));
  return law;
}

LawFit restitution_law_fit(const std::vector<MeanPoint>& points, double young_modulus,
                           double dissipation_time, const std::array<double, 2>& paper) {
  LawFit law;
  law.law = "restitution";
  law.points = points;
  law.parameters = {{"d1", {LawFit::kNaN, LawFit::kNaN}, paper[0]},
                    {"d2", {LawFit::kNaN, LawFit::kNaN}, paper[1]}};
  const double c = sound_speed(young_modulus);
  for (const MeanPoint& point : points) {
    law.theory.push_back(quasi_static_theory(young_modulus, dissipation_time, point.x * c));
  }
  set_fit(law, std::isnan(young_modulus) ? declined("young_modulus of this lattice is not known")
                                         : fit_restitution(weighted_by_runs(points)));
  return law;
}

}  // namespace impact
