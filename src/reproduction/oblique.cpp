#include "reproduction/oblique.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "fits/law_fit.hpp"
#include "fits/statistics.hpp"
#include "measure/flags.hpp"
#include "output/table.hpp"
#include "reproduction/ensemble.hpp"
#include "reproduction/reproduction.hpp"
#include "theory/turned_normal.hpp"

namespace impact {
namespace {

/// The wall of the paper, 8 R wide and 2 R deep, its sides and bottom fixed.
Scene on_wide_wall(const WallAndSpeed& wall) {
  Scene scene;
  scene.disk.recipe.points = 400;
  scene.wall.kind = WallKind::kLattice;
  scene.wall.boundary = Boundary::kFixed;
  scene.wall.points = 2037;
  scene.wall.width = 8.0;
  scene.wall.height = 2.0;
  scene.wall.k_a = wall.k_a;
  scene.wall.k_b = 0.0;
  scene.wall.eta = 0.0;
  scene.impact.velocity = wall.velocity;
  scene.numerics.error = 1e-2;
  return scene;
}

/// One impact at each angle and, beside it, a straight one with its velocity along y.
struct Throw {
  WallAndSpeed wall;
  double tangent;
  std::size_t oblique;   ///< its scene
  std::size_t straight;  ///< where γ = 0, the same
};

struct Plan {
  std::vector<Scene> scenes;
  std::vector<Throw> throws;
};

Plan planned_throws(const ObliqueThrows& throws) {
  Plan plan;
  for (const WallAndSpeed& wall : throws.walls) {
    for (const double tangent : throws.tangents) {
      if (tangent < wall.least) continue;
      Scene scene = on_wide_wall(wall);
      scene.impact.angle = std::atan(tangent) * 180.0 / M_PI;
      const std::size_t place = plan.scenes.size();
      plan.scenes.push_back(scene);
      plan.throws.push_back({wall, tangent, place, tangent == 0.0 ? place : place + 1});
      if (tangent == 0.0) continue;
      scene.impact.velocity = scene.impact.normal_velocity();
      scene.impact.angle = 0.0;
      plan.scenes.push_back(scene);
    }
  }
  return plan;
}

/// What one lattice says of one throw.
struct ObliqueImpact {
  double tan_gamma = 0.0;
  double restitution = 0.0;
  double straight = 0.0;     ///< e of the straight impact
  double slope = 0.0;        ///< of the surface, weighted by impulse: the impulse is normal to it
  double chord = 0.0;        ///< slope of the surface from edge to edge of the contact
  double wall_energy = 0.0;  ///< afterwards, in parts of the energy before, as the losses
  bool folded = false;

  double gain() const { return restitution - straight; }
  double on_slope() const { return restitution_on_slope(straight, slope, tan_gamma); }
  double on_chord() const { return restitution_on_slope(straight, chord, tan_gamma); }
  /// Restitution along the direction of the impulse.
  double along_impulse() const { return restitution_along_normal(restitution, slope, tan_gamma); }
  /// Of the motion along y.
  double normal_loss() const {
    return (1.0 - restitution * restitution) / (1.0 + tan_gamma * tan_gamma);
  }
  /// Of the motion along x, from which the impulse takes slope (1 + e) v cos γ.
  double tangential_loss() const {
    const double after = tan_gamma - slope * (1.0 + restitution);
    return (tan_gamma * tan_gamma - after * after) / (1.0 + tan_gamma * tan_gamma);
  }
};

ObliqueImpact oblique_impact(double tan_gamma, const Row& oblique, const Row& straight) {
  ObliqueImpact impact;
  const double velocity = oblique.scene.impact.velocity;
  impact.wall_energy = 2.0 * oblique.results.at("wall_energy") / (velocity * velocity);
  impact.tan_gamma = tan_gamma;
  impact.restitution = oblique.results.at("restitution");
  impact.straight = straight.results.at("restitution");
  impact.folded = has_flag(flags_of(oblique), Flag::kFolded);
  if (tan_gamma == 0.0) return impact;
  impact.slope = -oblique.results.at("impulse_ratio");
  impact.chord = oblique.results.at("surface_slope");
  return impact;
}

/// What is averaged over the lattices, by column.
struct ObliqueNumber {
  const char* column;
  std::function<double(const ObliqueImpact&)> value;
};

const std::vector<ObliqueNumber>& oblique_numbers() {
  static const std::vector<ObliqueNumber> numbers{
      {"restitution", [](const auto& impact) { return impact.restitution; }},
      {"straight", [](const auto& impact) { return impact.straight; }},
      {"gain", [](const auto& impact) { return impact.gain(); }},
      {"slope", [](const auto& impact) { return impact.slope; }},
      {"chord", [](const auto& impact) { return impact.chord; }},
      {"on_slope", [](const auto& impact) { return impact.on_slope(); }},
      {"on_chord", [](const auto& impact) { return impact.on_chord(); }},
      {"along_impulse", [](const auto& impact) { return impact.along_impulse(); }},
      {"normal_loss", [](const auto& impact) { return impact.normal_loss(); }},
      {"tangential_loss", [](const auto& impact) { return impact.tangential_loss(); }},
      {"wall_energy", [](const auto& impact) { return impact.wall_energy; }}};
  return numbers;
}

Table table_of_oblique_means() {
  std::vector<std::string> columns{"wall_k_a", "velocity", "tan_gamma",
                                   "lattices", "refused",  "folded"};
  for (const ObliqueNumber& number : oblique_numbers()) {
    columns.emplace_back(number.column);
    columns.push_back(std::string(number.column) + "_error");
  }
  return Table(columns);
}

Table table_of_oblique_impacts() {
  std::vector<std::string> columns{"wall_k_a", "velocity", "tan_gamma", "seed", "folded"};
  for (const ObliqueNumber& number : oblique_numbers()) columns.emplace_back(number.column);
  return Table(columns);
}

void add_impact(const Throw& one, std::uint64_t seed, const ObliqueImpact& impact, Table& table) {
  table << one.wall.k_a << one.wall.velocity << one.tangent << fmt::format("{}", seed)
        << fmt::format("{:d}", impact.folded);
  for (const ObliqueNumber& number : oblique_numbers()) table << number.value(impact);
}

void add_means(const Throw& one, const std::vector<ObliqueImpact>& impacts, int lattices,
               Table& table) {
  const auto counted = static_cast<std::ptrdiff_t>(impacts.size());
  const auto folded = std::count_if(impacts.begin(), impacts.end(),
                                    [](const ObliqueImpact& impact) { return impact.folded; });
  table << one.wall.k_a << one.wall.velocity << one.tangent << fmt::format("{}", counted)
        << fmt::format("{}", lattices - counted) << fmt::format("{}", folded);
  for (const ObliqueNumber& number : oblique_numbers()) {
    std::vector<double> values(impacts.size());
    std::transform(impacts.begin(), impacts.end(), values.begin(), number.value);
    const MeanPoint mean =
        values.empty() ? MeanPoint{0.0, LawFit::kNaN, LawFit::kNaN, 0} : mean_point(0.0, values);
    table << mean.y << mean.standard_error;
  }
}

bool has_answer(const Row& row) { return is_sound(flags_of(row)); }

}  // namespace

std::vector<Scene> scenes_of_oblique(int lattices, const ObliqueThrows& throws) {
  return with_seeds(planned_throws(throws).scenes, lattices);
}

void reproduce_oblique(const Reproduction& reproduction, const ObliqueThrows& throws) {
  const Plan plan = planned_throws(throws);
  const std::vector<Row> rows =
      simulate(reproduction, "oblique", scenes_of_oblique(reproduction.lattices, throws));

  Table means = table_of_oblique_means();
  Table singles = table_of_oblique_impacts();
  for (const Throw& one : plan.throws) {
    std::vector<ObliqueImpact> impacts;
    for (std::size_t first = 0; first < rows.size(); first += plan.scenes.size()) {
      const Row& oblique = rows[first + one.oblique];
      const Row& straight = rows[first + one.straight];
      if (!has_answer(oblique) || !has_answer(straight)) continue;
      impacts.push_back(oblique_impact(one.tangent, oblique, straight));
      add_impact(one, oblique.scene.seed, impacts.back(), singles);
    }
    add_means(one, impacts, reproduction.lattices, means);
  }
  means.write(reproduction.folder / "oblique.csv");
  singles.write(reproduction.folder / "oblique_impacts.csv");
}

}  // namespace impact
