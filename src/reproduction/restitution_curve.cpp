#include "reproduction/restitution_curve.hpp"

#include <fmt/format.h>

#include <cmath>

#include "theory/quasi_static.hpp"

namespace impact {
namespace {

const std::vector<double> kSpeeds{0.003,  0.0041, 0.0056, 0.0077, 0.0105,
                                  0.0143, 0.0196, 0.0268, 0.0366, 0.05};  // c
constexpr double kSpeedOfHardWall = 0.01;                                 // c

Ensemble in_units_of(Ensemble curves, double unit) {
  for (double& x : curves.x) x /= unit;
  return curves;
}

/// Without commas, which a table cannot hold.
std::string reason(std::string text) {
  for (char& letter : text) {
    if (letter == ',') letter = ';';
  }
  return text;
}

void add_fit(const std::string& name, const char* speed, const Ensemble& curves, double unit,
             Table& table) {
  const EnsembleFit result = fit_ensemble(in_units_of(curves, unit), fit_restitution);
  const Fit& fit = result.fit;
  table << name << speed << curves.x.front() << curves.x.back()
        << fmt::format("{}", curves.y.size());
  for (const std::size_t k : {0U, 1U}) {
    const bool there = fit.declined.empty();
    table << (there ? fit.parameters[k].value : LawFit::kNaN)
          << (there ? result.sampling_error[k] : LawFit::kNaN)
          << (there ? fit.parameters[k].standard_error : LawFit::kNaN);
  }
  table << (fit.declined.empty() ? fit.residual : LawFit::kNaN) << reason(fit.declined);
}

}  // namespace

std::vector<Scene> at_all_speeds(const Scene& scene) {
  std::vector<Scene> scenes(kSpeeds.size(), scene);
  for (std::size_t k = 0; k < kSpeeds.size(); ++k) scenes[k].impact.velocity = kSpeeds[k];
  return scenes;
}

double speed_of(const Scene& scene) { return scene.impact.velocity; }

Table fit_table() {
  return Table({"case", "speed_under_logarithm", "velocity_low", "velocity_high", "lattices", "d1",
                "d1_sampling_error", "d1_fit_error", "d2", "d2_sampling_error", "d2_fit_error",
                "residual", "declined"});
}

void add_fits(const std::string& name, const Ensemble& curves, const ElasticDisk& disk,
              Table& table) {
  const double c_s = sound_speed(disk.young_modulus);
  add_fit(name, "c_s", curves, c_s, table);
  add_fit(name, "c_s", above(curves, kSpeedOfHardWall), c_s, table);
  add_fit(name, "c", curves, 1.0, table);
}

std::vector<double> fitted_curve(const Ensemble& curves, const ElasticDisk& disk) {
  const Ensemble scaled = in_units_of(curves, sound_speed(disk.young_modulus));
  const Fit fit = fit_mean(scaled, fit_restitution);
  std::vector<double> curve(curves.x.size(), LawFit::kNaN);
  if (!fit.declined.empty()) return curve;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    curve[k] =
        closed_form_restitution(fit.parameters[0].value, fit.parameters[1].value, scaled.x[k]);
  }
  return curve;
}

}  // namespace impact
