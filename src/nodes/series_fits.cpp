#include "nodes/series_fits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fits/law_fit.hpp"
#include "fits/quasi_static_impact.hpp"
#include "measure/flags.hpp"
#include "nodes/conversions.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

constexpr double kNaN = LawFit::kNaN;

double abscissa(const Scene& scene) {
  return scene.kind == SceneKind::kContact ? scene.load.p : scene.impact.normal_velocity();
}

/// As YAML, all keys of the scene but the seed and this one.
std::string keys_but(const char* part, const char* key, const Scene& scene) {
  YAML::Node keys = write_parameters(scene_parameters(), scene);
  keys.remove("seed");
  keys[part].remove(key);
  return YAML::Dump(keys) + "\n";
}

/// The keys that must be equal for runs to be compared.
std::string shared_keys(const Scene& scene) {
  return scene.kind == SceneKind::kContact ? keys_but("load", "P", scene)
                                           : keys_but("impact", "velocity", scene);
}

std::string shared_keys_without_damping(Scene scene) {
  scene.material.eta = 0.0;
  return shared_keys(scene);
}

bool can_be_fitted(const ClosedRun& run) {
  return std::isfinite(run.answer) && is_sound(run.flags);
}

std::vector<MeanPoint> mean_points(const std::map<double, std::vector<double>>& answers,
                                   double unit_of_x) {
  std::vector<MeanPoint> points;
  points.reserve(answers.size());
  for (const auto& [x, values] : answers) points.push_back(mean_point(x / unit_of_x, values));
  return points;
}

lattice_impact::LawFit fit_contacts(const std::map<double, std::vector<double>>& answers,
                                    const DiskElasticity& elastic) {
  lattice_impact::LawFit message = to_message(hertz_law_fit(
      mean_points(answers, 1.0), {elastic.young_modulus.value, elastic.poisson_ratio.value}));
  message.dissipation_time = kNaN;
  return message;
}

/// d₁ and d₂ where the paper fits them in the same kind of scene.
std::array<double, 2> paper_values(const Scene& scene) {
  const bool absorbs =
      scene.wall.kind == WallKind::kLattice && scene.wall.boundary == Boundary::kReset;
  return absorbs ? kPaperAbsorbingWall : std::array<double, 2>{kNaN, kNaN};
}

lattice_impact::LawFit means_only(const std::string& name, const std::string& reason,
                                  std::vector<MeanPoint> points) {
  LawFit law;
  law.law = name;
  law.points = std::move(points);
  law.fit.declined = reason;
  lattice_impact::LawFit message = to_message(law);
  message.young_modulus = message.poisson_ratio = message.sound_speed = kNaN;
  message.dissipation_time = kNaN;
  return message;
}

double mean_restitution(const std::vector<double>& values) { return mean_point(0.0, values).y; }

}  // namespace

void SeriesFits::add(const ClosedRun& run) {
  const std::string key = shared_keys(run.scene);
  Group& changed = group_of(groups_, run.scene, key);
  const bool fitted = can_be_fitted(run);
  if (fitted) {
    changed.answers[abscissa(run.scene)].push_back(run.answer);
  } else {
    ++changed.left_out;
  }
  for (const auto& [shared, group] : groups_) {
    const bool gained_undamped_pair =
        fitted && group.undamped == key && group.answers.count(abscissa(run.scene)) > 0;
    if (&group != &changed && !gained_undamped_pair) continue;
    output(fit(group), run, shared, group);
  }
  if (run.scene.kind == SceneKind::kCollision) add_by_angle(run);
}

void SeriesFits::add_by_angle(const ClosedRun& run) {
  const std::string key = keys_but("impact", "angle", run.scene);
  Group& group = group_of(by_angle_, run.scene, key);
  if (can_be_fitted(run)) {
    group.answers[run.scene.impact.angle].push_back(run.answer);
  } else {
    ++group.left_out;
  }
  if (group.answers.size() > 1) {
    output(means_only("restitution_by_angle", "means only", mean_points(group.answers, 1.0)), run,
           key, group);
  }
}

void SeriesFits::output(lattice_impact::LawFit message, const ClosedRun& run,
                        const std::string& shared, const Group& group) const {
  message.header = run.header;
  message.run = run.number;
  message.scene = shared;
  message.left_out = group.left_out;
  output_(message);
}

SeriesFits::Group& SeriesFits::group_of(std::map<std::string, Group>& groups, const Scene& scene,
                                        const std::string& shared_keys) {
  const auto found = groups.find(shared_keys);
  if (found != groups.end()) return found->second;
  return groups.emplace(shared_keys, Group{scene, shared_keys_without_damping(scene)})
      .first->second;
}

lattice_impact::LawFit SeriesFits::fit(const Group& group) const {
  const DiskElasticity elastic = disk_elasticity(group.scene, elastic_);
  lattice_impact::LawFit message = group.scene.kind == SceneKind::kContact
                                       ? fit_contacts(group.answers, elastic)
                                       : fit_collisions(group, elastic);
  message.young_modulus = elastic.young_modulus.value;
  message.young_modulus_origin = elastic.young_modulus.origin;
  message.poisson_ratio = elastic.poisson_ratio.value;
  message.poisson_ratio_origin = elastic.poisson_ratio.origin;
  message.sound_speed = sound_speed(elastic.young_modulus.value);
  return message;
}

lattice_impact::LawFit SeriesFits::fit_collisions(const Group& group,
                                                  const DiskElasticity& elastic) const {
  const double young_modulus = elastic.young_modulus.value;
  std::vector<MeanPoint> points = mean_points(group.answers, sound_speed(young_modulus));
  if (group.scene.hits_disk()) {
    return means_only("restitution", "means only: the theory is that of a wall", std::move(points));
  }
  const DissipationTime dissipation = measure_dissipation(group, young_modulus);
  lattice_impact::LawFit message = to_message(
      restitution_law_fit(points, young_modulus, dissipation.value, paper_values(group.scene)));
  message.dissipation_time = dissipation.value;
  message.dissipation_time_origin = dissipation.origin;
  return message;
}

SeriesFits::DissipationTime SeriesFits::measure_dissipation(const Group& group,
                                                            double young_modulus) const {
  const bool absorbs = group.scene.wall.kind == WallKind::kLattice;
  if (group.scene.material.eta == 0.0 && !absorbs) return {0.0, "η* = 0"};
  if (group.answers.empty()) return {kNaN, "no answer yet"};
  const auto undamped = groups_.find(group.undamped);
  if (undamped != groups_.end() && &undamped->second != &group) {
    for (auto at = group.answers.rbegin(); at != group.answers.rend(); ++at) {
      const auto pair = undamped->second.answers.find(at->first);
      if (pair == undamped->second.answers.end()) continue;
      const double excess =
          std::pow(mean_restitution(pair->second), 2) - std::pow(mean_restitution(at->second), 2);
      return {dissipation_time(young_modulus, at->first, excess),
              fmt::format("loss in excess of that with η* = 0 at v = {} c", at->first)};
    }
  }
  const auto& [velocity, restitutions] = *group.answers.rbegin();
  return {
      dissipation_time(young_modulus, velocity, 1.0 - std::pow(mean_restitution(restitutions), 2)),
      fmt::format("all loss at v = {} c", velocity)};
}

std::string outcome(const lattice_impact::LawFit& law) {
  std::string text = fmt::format("{} law of {} points", law.law, law.x.size());
  if (!law.declined.empty()) return fmt::format("{}: not fitted, {}", text, law.declined);
  for (std::size_t k = 0; k < law.names.size(); ++k) {
    text +=
        fmt::format(", {} = {:.6g} +- {:.2g}", law.names[k], law.values[k], law.standard_errors[k]);
  }
  return text;
}

}  // namespace impact
