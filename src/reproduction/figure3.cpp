#include <fmt/format.h>

#include <cmath>

#include "fits/quasi_static_impact.hpp"
#include "output/table.hpp"
#include "reproduction/ensemble.hpp"
#include "reproduction/reproduction.hpp"
#include "reproduction/restitution_curve.hpp"

namespace impact {
namespace {

/// The curves of one wall: no damping first, then rising.
struct Wall {
  double a;                       ///< inverse range, 1/R
  std::vector<double> viscosity;  ///< η*
};

/// The paper's wall, and one so hard that its own range counts less.
std::vector<Wall> walls() {
  return {{300.0, {0.0, 0.1, 1.0, 3.0, 10.0, 30.0, 100.0}}, {3000.0, {0.0, 1.0, 10.0, 100.0}}};
}

std::vector<Scene> collisions() {
  std::vector<Scene> scenes;
  for (const Wall& wall : walls()) {
    for (const double eta : wall.viscosity) {
      Scene scene;
      scene.wall.a = wall.a;
      scene.material.eta = eta;
      for (const Scene& one : at_all_speeds(scene)) scenes.push_back(one);
    }
  }
  return scenes;
}

/// The dissipation time (R/c) with which eq. (4) has the loss that damping adds, at each speed.
std::vector<double> dissipation_times(const std::vector<MeanPoint>& damped,
                                      const std::vector<MeanPoint>& undamped, double modulus) {
  std::vector<double> times;
  for (std::size_t k = 0; k < damped.size(); ++k) {
    const double excess = std::pow(undamped[k].y, 2) - std::pow(damped[k].y, 2);
    times.push_back(dissipation_time(modulus, damped[k].x, excess));
  }
  return times;
}

/// η/k_a in R/c: the time constant of one bond.
double bond_time(double eta) { return eta / Scene{}.disk.recipe.points; }

/// What was measured on one wall: a curve for each viscosity.
struct Measured {
  std::vector<Ensemble> restitution;
  std::vector<Ensemble> duration;
};

void add_lines(const Wall& wall, std::size_t k, const Measured& measured, double time_by_bond_time,
               const ElasticDisk& disk, Table& table) {
  const double c = sound_speed(disk.young_modulus);
  const double paper_modulus = disk.young_modulus / (1.0 - disk.poisson_ratio * disk.poisson_ratio);
  const std::vector<MeanPoint> curve = mean_curve(measured.restitution[k]);
  const std::vector<MeanPoint> durations = mean_curve(measured.duration[k]);
  const std::vector<double> times =
      dissipation_times(curve, mean_curve(measured.restitution[0]), disk.young_modulus);
  const std::vector<double> fitted = fitted_curve(measured.restitution[k], disk);
  const double tau = time_by_bond_time * bond_time(wall.viscosity[k]);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double v = curve[i].x;
    const QuasiStaticImpact plane_stress{disk.young_modulus, tau, v};
    const QuasiStaticImpact paper{paper_modulus, tau, v};
    table << wall.a << wall.viscosity[k] << v << v / c << fmt::format("{}", curve[i].runs)
          << curve[i].y << curve[i].standard_error << fitted[i] << durations[i].y
          << contact_time(c, v) << times[i] << times[i] / bond_time(wall.viscosity[k]) << tau
          << quasi_static_restitution(plane_stress, EndOfImpact::kNoCompression, c)
          << quasi_static_restitution(plane_stress, EndOfImpact::kContactTime, c)
          << quasi_static_restitution(paper, EndOfImpact::kNoCompression, c)
          << closed_form_restitution(1.0, paper_d2(plane_stress, c), v / c);
  }
}

/// Where the part 1 − e² of the energy went: into the turning disk, into damping, and the rest into
/// vibrations.
Row with_losses(Row row) {
  const double e = row.results.at("restitution");
  const double loss = 1.0 - e * e;
  const double spin = std::pow(row.results.at("energy_restitution"), 2) - e * e;
  const double damping = 2.0 * row.results.at("dissipated") / std::pow(speed_of(row.scene), 2);
  row.results["loss"] = loss;
  row.results["spin"] = spin;
  row.results["damping"] = damping;
  row.results["vibration"] = loss - spin - damping;
  return row;
}

void add_losses(const Wall& wall, double eta, const std::vector<Row>& rows, Table& table) {
  std::vector<Row> divided;
  divided.reserve(rows.size());
  for (const Row& row : rows) divided.push_back(has_failed(row) ? row : with_losses(row));
  std::vector<std::vector<MeanPoint>> curves;
  for (const char* part : {"loss", "spin", "damping", "vibration"}) {
    curves.push_back(mean_curve(ensemble(divided, speed_of, part)));
  }
  for (std::size_t i = 0; i < curves[0].size(); ++i) {
    table << wall.a << eta << curves[0][i].x << fmt::format("{}", curves[0][i].runs);
    for (const auto& curve : curves) table << curve[i].y << curve[i].standard_error;
  }
}

/// τ₀ over η/k_a at the smallest viscosity and the greatest speed, where the wall counts least.
double measured_time_by_bond_time(const Wall& wall, const Measured& measured, double modulus) {
  return dissipation_times(mean_curve(measured.restitution[1]), mean_curve(measured.restitution[0]),
                           modulus)
             .back() /
         bond_time(wall.viscosity[1]);
}

}  // namespace

std::vector<Scene> scenes_of_figure3(int lattices) { return with_seeds(collisions(), lattices); }

void reproduce_figure3(const Reproduction& reproduction, const Material& material) {
  const ElasticDisk& disk = material.blue_noise;
  const std::vector<Row> rows =
      simulate(reproduction, "figure3", scenes_of_figure3(reproduction.lattices));

  Table table({"wall_a", "eta", "velocity", "velocity_by_sound_speed", "lattices", "restitution",
               "restitution_error", "fit", "contact_duration", "contact_duration_theory",
               "dissipation_time", "dissipation_time_by_eta_by_k_a", "dissipation_time_used", "ode",
               "ode_to_contact_time", "ode_paper_modulus", "closed_form"});
  Table losses({"wall_a", "eta", "velocity", "lattices", "loss", "loss_error", "spin", "spin_error",
                "damping", "damping_error", "vibration", "vibration_error"});
  Table fits = fit_table();
  const std::size_t speeds = at_all_speeds({}).size();
  std::size_t first = 0;
  for (const Wall& wall : walls()) {
    Measured measured;
    for (std::size_t k = 0; k < wall.viscosity.size(); ++k, first += speeds) {
      const std::vector<Row> rows_of_curve = every(rows, first, speeds, collisions().size());
      measured.restitution.push_back(ensemble(rows_of_curve, speed_of, "restitution"));
      measured.duration.push_back(ensemble(rows_of_curve, speed_of, "contact_duration"));
      add_losses(wall, wall.viscosity[k], rows_of_curve, losses);
    }
    const double time = measured_time_by_bond_time(wall, measured, disk.young_modulus);
    for (std::size_t k = 0; k < wall.viscosity.size(); ++k) {
      add_lines(wall, k, measured, time, disk, table);
      add_fits(fmt::format("a = {} eta* = {}", wall.a, wall.viscosity[k]), measured.restitution[k],
               disk, fits);
    }
  }
  table.write(reproduction.folder / "figure3.csv");
  losses.write(reproduction.folder / "figure3_losses.csv");
  fits.write(reproduction.folder / "figure3_fits.csv");
}

}  // namespace impact
