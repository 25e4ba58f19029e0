#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/table.hpp"
#include "reproduction/ensemble.hpp"
#include "reproduction/reproduction.hpp"
#include "run/run.hpp"

namespace impact {
namespace {

const std::vector<double> kLoads{0.004, 0.005, 0.006, 0.007, 0.008, 0.009, 0.010};  // M c²/R
constexpr ElasticDisk kPaperDisk{1.0, 0.075};  // only P/(πE) counts, so E may be 1

/// Pressure is sampled in bins of this part of Hertz's half width.
constexpr double kBin = 0.1;
constexpr int kBins = 40;
constexpr double kReach = 2.0;  // half widths to either side

Scene contact(double load) {
  Scene scene;
  scene.kind = SceneKind::kContact;
  scene.load.p = load;
  scene.numerics.integrator = IntegratorKind::kNewton;
  return scene;
}

/// The same loads for each reading of the model that is compared.
struct ContactCase {
  const char* name;
  Scene scene;
};

std::vector<ContactCase> contact_cases() {
  std::vector<ContactCase> all;
  const auto add = [&all](const char* name) -> Scene& {
    all.push_back({name, contact(kLoads.back())});
    return all.back().scene;
  };
  add("default");
  add("uniform placement").disk.recipe.placement = Placement::kUniform;
  add("without rim").disk.recipe.rim = false;
  add("free to roll").load.hold_rotation = false;
  add("N = 4396").disk.recipe.points = 4396;
  add("k_b = 0").material.k_b = 0.0;
  add("a = 1000/R").wall.a = 1000.0;
  add("a = 3000/R").wall.a = 3000.0;
  return all;
}

std::vector<Scene> loaded(const Scene& scene) {
  std::vector<Scene> scenes(kLoads.size(), scene);
  for (std::size_t k = 0; k < kLoads.size(); ++k) scenes[k].load.p = kLoads[k];
  return scenes;
}

double load_of(const Scene& scene) { return scene.load.p; }

/// b; NaN where the fit is declined.
Estimate factor(const Fit& fit) {
  return fit.declined.empty() ? fit.parameters[0] : Estimate{LawFit::kNaN, LawFit::kNaN};
}

void write_curve(const Reproduction& reproduction, const Ensemble& curves, const Fit& fit,
                 const ElasticDisk& disk) {
  Table table({"P", "P_by_pi_E_R", "lattices", "strain", "strain_error", "fit", "hertz",
               "inertial_load", "paper_fit"});
  const double b = 1.0 - disk.poisson_ratio * disk.poisson_ratio;
  for (const MeanPoint& point : mean_curve(curves)) {
    const double scaled = point.x / (M_PI * disk.young_modulus);
    table << point.x << scaled << fmt::format("{}", point.runs) << point.y << point.standard_error
          << hertz_compression(disk, factor(fit).value, point.x)
          << hertz_compression(disk, b, point.x) << inertial_load_compression(disk, point.x)
          << hertz_compression(kPaperDisk, kPaperHertzFactor, M_PI * scaled);
  }
  table.write(reproduction.folder / "figure2.csv");
}

/// b of a plane-stress disk under a uniform body force, over the same loads.
double factor_of_inertial_load(const Ensemble& curves, const ElasticDisk& disk) {
  std::vector<DataPoint> points;
  for (const double load : curves.x) {
    points.push_back({load, inertial_load_compression(disk, load), 1.0});
  }
  return factor(fit_hertz(points, disk)).value;
}

void add_fit(const char* name, const EnsembleFit& fit, const Ensemble& curves,
             const ElasticDisk& disk, Table& table) {
  const bool there = fit.fit.declined.empty();
  const Estimate b = factor(fit.fit);
  table << name << disk.young_modulus << disk.poisson_ratio << fmt::format("{}", curves.y.size())
        << b.value << (there ? fit.sampling_error[0] : LawFit::kNaN) << b.standard_error
        << (there ? fit.fit.residual : LawFit::kNaN)
        << 1.0 - disk.poisson_ratio * disk.poisson_ratio << factor_of_inertial_load(curves, disk)
        << kPaperHertzFactor;
}

/// Force on the points in contact, each spread over the piece of rim that belongs to its point, by
/// the place in units of Hertz's half width from the middle of the pressure.
class PressureProfile {
 public:
  PressureProfile(double half_width, double spacing)
      : half_width_(half_width), piece_(spacing / half_width), force_(kBins, 0.0) {}

  void add(const PointArray& position, const std::vector<PointForce>& contacts) {
    double middle = 0.0;
    double total = 0.0;
    for (const PointForce& contact : contacts) {
      middle += contact.force.y() * position(contact.point, 0);
      total += contact.force.y();
    }
    middle /= total;
    for (const PointForce& contact : contacts) {
      spread((position(contact.point, 0) - middle) / half_width_, contact.force.y() / total);
    }
    ++lattices_;
  }

  /// Mean pressure in a bin, in units of P/a_c.
  double pressure(int bin) const {
    return force_[static_cast<std::size_t>(bin)] / (lattices_ * kBin);
  }

 private:
  void spread(double x, double force) {
    for (int bin = 0; bin < kBins; ++bin) {
      const double begin = bin * kBin - kReach;
      const double overlap =
          std::min(begin + kBin, x + 0.5 * piece_) - std::max(begin, x - 0.5 * piece_);
      force_[static_cast<std::size_t>(bin)] += force * std::max(0.0, overlap) / piece_;
    }
  }

  double half_width_;
  double piece_;  ///< of the rim, in half widths
  std::vector<double> force_;
  int lattices_ = 0;
};

PressureProfile pressure_profile(const Reproduction& reproduction, const ElasticDisk& disk,
                                 const Scene& scene, int lattices) {
  PressureProfile profile(contact_half_width(disk, scene.load.p),
                          std::sqrt(M_PI / scene.disk.recipe.points));
  for (const Scene& one : with_seeds({scene}, std::min(lattices, reproduction.lattices))) {
    break_off_if_interrupted();
    Run run(one);
    run.advance();
    if (!run.flags().empty()) continue;
    profile.add(run.state().position, run.take_contact_reports().on_first.points);
  }
  return profile;
}

void write_pressure(const Reproduction& reproduction, const ElasticDisk& disk) {
  Scene coarse = contact(kLoads.back());
  Scene fine = coarse;
  fine.disk.recipe.points = 16000;
  Scene fine_and_hard = fine;
  fine_and_hard.wall.a = 3000.0;
  constexpr int kManyLattices = 1000;
  constexpr int kFewLattices = 16;
  const PressureProfile of_coarse = pressure_profile(reproduction, disk, coarse, kManyLattices);
  const PressureProfile of_fine = pressure_profile(reproduction, disk, fine, kFewLattices);
  const PressureProfile of_hard = pressure_profile(reproduction, disk, fine_and_hard, kFewLattices);

  Table table({"x_by_half_width", "hertz", "N_1099", "N_16000", "N_16000_a_3000"});
  for (int bin = 0; bin < kBins; ++bin) {
    const double x = (bin + 0.5) * kBin - kReach;
    const double inside = std::max(0.0, 1.0 - x * x);
    table << x << 2.0 / M_PI * std::sqrt(inside) << of_coarse.pressure(bin) << of_fine.pressure(bin)
          << of_hard.pressure(bin);
  }
  table.write(reproduction.folder / "figure2_pressure.csv");
}

}  // namespace

std::vector<Scene> scenes_of_figure2(int lattices) {
  std::vector<Scene> scenes;
  for (const ContactCase& one : contact_cases()) {
    const std::vector<Scene> loads = loaded(one.scene);
    scenes.insert(scenes.end(), loads.begin(), loads.end());
  }
  return with_seeds(scenes, lattices);
}

void reproduce_figure2(const Reproduction& reproduction, const Material& material) {
  const std::vector<ContactCase> all = contact_cases();
  const std::vector<Row> rows =
      simulate(reproduction, "figure2", scenes_of_figure2(reproduction.lattices));

  Table fits({"case", "young_modulus", "poisson_ratio", "lattices", "b", "b_sampling_error",
              "b_fit_error", "residual", "theory", "inertial_load", "paper"});
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Ensemble curves =
        ensemble(every(rows, k * kLoads.size(), kLoads.size(), all.size() * kLoads.size()), load_of,
                 "strain");
    const ElasticDisk& disk = material.of(all[k].scene.disk.recipe.placement);
    const EnsembleFit fit = fit_ensemble(
        curves, [&disk](const std::vector<DataPoint>& points) { return fit_hertz(points, disk); });
    add_fit(all[k].name, fit, curves, disk, fits);
    if (k == 0) write_curve(reproduction, curves, fit.fit, disk);
  }
  fits.write(reproduction.folder / "figure2_fits.csv");
  write_pressure(reproduction, material.blue_noise);
}

}  // namespace impact
