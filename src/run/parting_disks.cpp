#include "run/parting_disks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/body_motion.hpp"
#include "run/expected_time.hpp"

namespace impact {
namespace {

constexpr double kStill = 1e-3;  // of the impact's energy

}  // namespace

PartingDisks::PartingDisks(const Scene& scene, const Bodies& bodies)
    : remaining_(remaining_fraction(scene)),
      impact_energy_(impact_energy(scene, reduced_mass(scene, bodies))) {
  const auto points = static_cast<double>(bodies.disk().points.rows());
  for (const BodyOfScene& body : bodies.all) {
    const bool is_first = disks_.empty();
    disks_.emplace_back(body.lattice, body.triangles, body.flexibility,
                        is_first ? scene.material : scene.wall_material(), std::sqrt(M_PI / points),
                        static_cast<double>(body.lattice.points.rows()) / points);
  }
}

double PartingDisks::energy_bound(const System& system, double most) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const ForceField& field = system.field();
  const State& state = system.state();
  std::vector<Flyer> flyers;
  for (std::size_t k = 0; k < disks_.size(); ++k) {
    const Body body = field.body(k);
    const PointArray position = body.rows_of(state.position);
    flyers.push_back({position, body_motion(position, body.rows_of(state.velocity))});
  }
  std::vector<Pair> parting;
  for (std::size_t i = 0; i < flyers.size(); ++i) {
    for (std::size_t j = i + 1; j < flyers.size(); ++j) {
      const bool are_ends = i == 0 && j + 1 == flyers.size();
      if (!are_ends && stand_still(system, flyers, {i, j})) continue;
      const BodyMotion& one = flyers[i].motion;
      const BodyMotion& other = flyers[j].motion;
      const double apart = ((one.centre - other.centre) * (one.velocity - other.velocity)).sum();
      if (!(apart > 0.0)) return kInfinity;
      parting.emplace_back(i, j);
    }
  }
  const double energy = field.impact_energy(flyers.front().motion.velocity.y());
  const auto contacts_of_points =
      static_cast<double>(state.position.rows()) * static_cast<double>(flyers.size() - 1);
  const Contact& contact = *field.contact();
  const std::vector<double> reach = reaches(system, flyers);
  const auto holds = [&](double fraction) {
    const double gap = std::min(contact.gap_of_energy(fraction * energy / contacts_of_points),
                                contact.threshold());
    return std::all_of(parting.begin(), parting.end(), [&](const Pair& pair) {
      const auto [i, j] = pair;
      const Eigen::Array2d apart = flyers[i].motion.centre - flyers[j].motion.centre;
      return apart.matrix().norm() >= reach[i] + reach[j] + gap;
    });
  };
  return least_that(holds, most);
}

bool PartingDisks::stand_still(const System& system, const std::vector<Flyer>& flyers,
                               Pair pair) const {
  const auto [i, j] = pair;
  const ForceField& field = system.field();
  const double one = field.mass_of(field.body(i));
  const double other = field.mass_of(field.body(j));
  const double squared = (flyers[i].motion.velocity - flyers[j].motion.velocity).square().sum();
  const double energy = 0.5 * one * other / (one + other) * squared;
  if (energy > kStill * impact_energy_) return false;
  return field.disk_contacts->potential_energy(i, j, system.state().position) <=
         remaining_ * impact_energy_;
}

std::vector<double> PartingDisks::reaches(const System& system, const std::vector<Flyer>& flyers) {
  std::vector<double> all;
  for (std::size_t k = 0; k < flyers.size(); ++k) {
    const auto& [position, motion] = flyers[k];
    all.push_back(disks_[k].reach(inner_motion(system, system.field().body(k), motion), position));
  }
  return all;
}

}  // namespace impact
