#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "output/progress_bar.hpp"
#include "output/table.hpp"
#include "scene/scene_parameters.hpp"
#include "verification/pareto.hpp"
#include "verification/work_precision.hpp"

namespace impact {
namespace {

constexpr double kLeastError = 1e-10;  // that a scene may ask for
constexpr double kNoOutput = 1e6;      // R/c: output.period of a scene that is only to be answered
constexpr double kGrid = 0.02;         // R/c: which all reset and report intervals divide

struct TestScene {
  std::string name;
  Scene scene;
};

/// Fewer points of the same material, in a fast impact.
void make_small(Scene& scene) {
  constexpr int kPoints = 60;
  scene.material.eta *= static_cast<double>(kPoints) / scene.disk.recipe.points;
  scene.disk.recipe.points = kPoints;
  scene.wall.points = kPoints;
  scene.impact.velocity = 0.05;
}

std::vector<TestScene> test_scenes(bool quick) {
  Scene contact;
  contact.kind = SceneKind::kContact;
  contact.material.eta = 100.0;
  std::vector<TestScene> scenes{{"contact", contact}};
  for (const double eta : {0.0, 1.0, 100.0}) {
    Scene collision;
    collision.impact.velocity = 0.05;
    collision.material.eta = eta;
    scenes.push_back({fmt::format("collision_eta{}", eta), collision});
  }
  Scene absorbing;
  absorbing.wall.kind = WallKind::kLattice;
  scenes.push_back({"absorbing_wall", absorbing});
  for (TestScene& one : scenes) {
    one.scene.output.period = kNoOutput;
    if (quick) make_small(one.scene);
  }
  return scenes;
}

std::vector<IntegratorKind> integrators_of(const Scene& scene) {
  std::vector<IntegratorKind> list;
  for (const auto& entry : integrator_names()) {
    const bool moves_all_points = !moves_less_than_all(entry.second);
    if (entry.second != IntegratorKind::kAuto && moves_all_points &&
        can_have(scene, entry.second)) {
      list.push_back(entry.second);
    }
  }
  return list;
}

/// What errors are measured against: the answer of one method, and how far another one is off it.
struct Reference {
  Outcome outcome;
  double end = 0.0;  ///< time of the states that are compared, R/c
  std::string methods;
  double uncertainty = 0.0;           ///< of the answer, relative
  double position_uncertainty = 0.0;  ///< R

  double error_of(const Outcome& other) const {
    return std::abs(other.answer - outcome.answer) / std::abs(outcome.answer);
  }
  /// Root mean square over the points, in R.
  double position_error_of(const Outcome& other) const {
    if (other.position.rows() != outcome.position.rows()) return Outcome::kNaN;
    const auto points = static_cast<double>(other.position.rows());
    return std::sqrt((other.position - outcome.position).square().sum() / points);
  }
};

Reference agreement(const Outcome& first, const Outcome& second, double end, std::string methods) {
  Reference reference{first, end, std::move(methods)};
  reference.uncertainty = reference.error_of(second);
  reference.position_uncertainty = reference.position_error_of(second);
  return reference;
}

/// The static solution against damped motion, which comes to rest as nearly as rounding lets it.
Reference rest_reference(Scene scene) {
  constexpr double kTolerance = 1e-3;  // of the way, on which the place of rest does not depend
  scene.numerics.error = kLeastError;
  scene.numerics.integrator = IntegratorKind::kNewton;
  const Outcome still = outcome_of(scene, Until::kAnswer);
  scene.numerics.integrator = IntegratorKind::kBdf;
  scene.numerics.tolerance = kTolerance;
  const Outcome moved = outcome_of(scene, Until::kAnswer);
  return agreement(still, moved, Outcome::kNaN,
                   fmt::format("newton; bdf tolerance {:g}", kTolerance));
}

/// Shortly before any run ends: the disk has left the wall. In short steps, since a run looks
/// every few of them whether it is over, and must not end before this.
double common_end(Scene scene) {
  constexpr double kMargin = 0.3;  // R/c
  scene.numerics.step = kGrid / 5.0;
  Run run(scene);
  while (!run.finished()) run.advance();
  return kGrid * std::floor((run.state().time - kMargin) / kGrid);
}

/// rk8pd with a small tolerance against a method of order 6, in the steps with which it comes
/// nearest: in longer ones the method errs more, in shorter ones rounding adds up.
Reference collision_reference(Scene scene) {
  constexpr double kTolerance = 1e-13;
  Scene::Numerics& numerics = scene.numerics;
  numerics.error = kLeastError;
  numerics.integrator = most_exact(scene);
  const double longest = longest_step(scene, numerics.integrator);
  numerics.step = 0.5 * longest;
  const double end = common_end(scene);
  scene.output.period = end;

  Scene independent = scene;
  independent.numerics.integrator = IntegratorKind::kRk8pd;
  independent.numerics.step.reset();
  independent.numerics.tolerance = kTolerance;
  const Outcome best = outcome_of(independent, Until::kTime);
  std::optional<Reference> nearest;
  for (const double shorter : {3.0, 6.0, 12.0}) {
    numerics.step = end / std::ceil(end / longest * shorter);
    const Outcome fine = outcome_of(scene, Until::kTime);
    Reference reference = agreement(best, fine, end,
                                    fmt::format("rk8pd tolerance {:g}; {} step {:.4g}", kTolerance,
                                                name_of(numerics.integrator), fine.step));
    if (!nearest || reference.uncertainty < nearest->uncertainty) nearest = std::move(reference);
  }
  return *nearest;
}

/// The numerics of ever finer runs of one integrator up to time `end`.
std::vector<Scene::Numerics> settings(const Scene& scene, double end, double finer) {
  constexpr int kMostSettings = 40;
  constexpr int kLeastPower = 2;
  constexpr int kMostPower = 14;
  std::vector<Scene::Numerics> list;
  Scene::Numerics numerics = scene.numerics;
  if (is_adaptive(numerics.integrator)) {
    for (int power = kLeastPower; power <= kMostPower; ++power) {
      numerics.tolerance = std::pow(10.0, -power);
      list.push_back(numerics);
    }
    return list;
  }
  const double longest = longest_step(scene, numerics.integrator);
  for (int k = 0; k < kMostSettings; ++k) {
    numerics.step = end / std::ceil(end / longest * std::pow(finer, k));
    list.push_back(numerics);
  }
  return list;
}

const char* kind_of(const TimedScene& one) {
  return one.until() == Until::kTime ? "run" : one.is_verified() ? "verified" : "bare";
}

/// All that is measured of one scene.
class ScenePrecision {
 public:
  ScenePrecision(TestScene scene, const Effort& effort)
      : scene_(std::move(scene)),
        effort_(effort),
        moves_(scene_.scene.kind == SceneKind::kCollision),
        reference_(moves_ ? collision_reference(scene_.scene) : rest_reference(scene_.scene)) {}

  void measure() {
    if (moves_) {
      measure_motion();
    } else {
      measure_contact();
    }
    for (const double error : effort_.errors()) verify(IntegratorKind::kAuto, error);
    repeat_in_turn(all_, effort_);
  }

  void write(const std::filesystem::path& folder) const;
  void add_reference(Table& table) const;
  void add_best(Table& table) const;

 private:
  double error_of(const TimedScene& one) const { return reference_.error_of(one.outcome()); }
  /// Whether it belongs to the curve of an integrator.
  bool on_curve(const TimedScene& one) const {
    return moves_ ? one.until() == Until::kTime
                  : one.scene().numerics.integrator != IntegratorKind::kAuto;
  }
  /// False when it took longer than this (s), in which case it does not count.
  bool add(TimedScene one, double longest) {
    throw_if_interrupted();
    one.run(longest);
    const bool in_time = one.has_answer() || one.spent() < longest;
    if (in_time) all_.push_back(std::move(one));
    return in_time;
  }

  bool verify(IntegratorKind integrator, double error) {
    const double runs = moves_ ? 3.0 : 1.0;  // that error control may need
    Scene scene = scene_.scene;
    scene.numerics.integrator = integrator;
    scene.numerics.error = error;
    return add({scene, Until::kAnswer}, runs * effort_.longest);
  }

  using Curve = std::vector<TimedScene>;  // of one integrator, from coarse to fine

  void measure_contact();
  void measure_motion();
  Curve sweep(IntegratorKind integrator) const;
  void answer(const std::vector<Curve>& curves, double error);

  /// The fastest of the timed scenes that keep this error.
  const TimedScene* best(double error, const std::function<bool(const TimedScene&)>& chosen) const;

  TestScene scene_;
  Effort effort_;
  bool moves_;
  Reference reference_;
  std::vector<TimedScene> all_;
};

/// From coarse to fine, until the error cannot be shown any more or runs take too long.
ScenePrecision::Curve ScenePrecision::sweep(IntegratorKind integrator) const {
  Scene scene = scene_.scene;
  scene.output.period = reference_.end;
  scene.numerics.integrator = integrator;
  scene.numerics.error = kLeastError;
  constexpr double kUnknown = 2.0;  // times the uncertainty of the reference
  Curve list;
  for (const Scene::Numerics& numerics : settings(scene, reference_.end, effort_.finer)) {
    throw_if_interrupted();
    scene.numerics = numerics;
    TimedScene one(scene, Until::kTime);
    one.run(effort_.longest);
    const bool too_long = one.spent() > 0.5 * effort_.longest;
    const bool same =
        !list.empty() && numerics.step && one.outcome().step == list.back().outcome().step;
    if (one.has_answer() && !same) list.push_back(one);
    if (too_long || error_of(one) <= kUnknown * reference_.uncertainty) break;
  }
  return list;
}

/// Motion, which takes long, for every second error only.
void ScenePrecision::measure_contact() {
  const std::vector<double> errors = effort_.errors();
  for (const IntegratorKind integrator : integrators_of(scene_.scene)) {
    const std::size_t stride = integrator == IntegratorKind::kNewton ? 1 : 2;
    for (std::size_t k = 0; k < errors.size(); k += stride) {
      if (!verify(integrator, errors[k])) break;
    }
  }
}

void ScenePrecision::measure_motion() {
  std::vector<Curve> curves;
  for (const IntegratorKind integrator : integrators_of(scene_.scene)) {
    curves.push_back(sweep(integrator));
  }
  for (const double error : effort_.errors()) answer(curves, error);
  for (const Curve& curve : curves) all_.insert(all_.end(), curve.begin(), curve.end());
}

/// Answers within this error by the integrators that may be the fastest for it.
void ScenePrecision::answer(const std::vector<Curve>& curves, double error) {
  constexpr double kMayBeFastest = 3.0;  // in the time of the fastest sufficient run
  std::vector<std::pair<const Curve*, std::size_t>> sufficient;
  double least_time = std::numeric_limits<double>::infinity();
  for (const Curve& curve : curves) {
    std::vector<double> errors;
    errors.reserve(curve.size());
    for (const TimedScene& one : curve) errors.push_back(error_of(one));
    const auto coarsest = coarsest_sufficient(errors, error);
    if (!coarsest) continue;
    sufficient.emplace_back(&curve, *coarsest);
    least_time = std::min(least_time, curve[*coarsest].spent());
  }
  for (const auto& [curve, coarsest] : sufficient) {
    if ((*curve)[coarsest].spent() > kMayBeFastest * least_time) continue;
    for (std::size_t k = coarsest; k < std::min(coarsest + 2, curve->size()); ++k) {
      Scene scene = (*curve)[k].scene();
      scene.numerics.error = error;
      scene.output.period = kNoOutput;
      add({scene, Until::kAnswer}, effort_.longest);
    }
    verify((*curve)[coarsest].scene().numerics.integrator, error);
  }
}

void ScenePrecision::write(const std::filesystem::path& folder) const {
  std::vector<WorkAndError> curves;
  for (const TimedScene& one : all_) {
    curves.push_back({one.median_time(), on_curve(one) ? error_of(one) : Outcome::kNaN});
  }
  const std::vector<std::size_t> front = pareto_front(curves);
  Table table({"kind", "integrator", "wanted_error", "step", "tolerance", "chosen", "repeats",
               "time", "wall_time", "force_evaluations", "error", "position_error", "energy_error",
               "estimated_error", "on_front", "flags"});
  for (std::size_t k = 0; k < all_.size(); ++k) {
    const TimedScene& one = all_[k];
    const Scene::Numerics& numerics = one.scene().numerics;
    const Outcome& outcome = one.outcome();
    const bool is_run = one.until() == Until::kTime;
    table << kind_of(one) << name_of(numerics.integrator)
          << (is_run ? Outcome::kNaN : numerics.error) << outcome.step
          << numerics.tolerance.value_or(Outcome::kNaN) << name_of(outcome.integrator)
          << static_cast<double>(one.runs()) << one.median_time() << one.median_wall_time()
          << outcome.evaluations << error_of(one)
          << (is_run || !moves_ ? reference_.position_error_of(outcome) : Outcome::kNaN)
          << outcome.energy_error << outcome.estimated_error
          << static_cast<double>(std::count(front.begin(), front.end(), k)) << outcome.flags;
  }
  table.write(folder / fmt::format("work_precision_{}.csv", scene_.name));
}

void ScenePrecision::add_reference(Table& table) const {
  table << scene_.name << reference_.outcome.answer << reference_.uncertainty
        << reference_.position_uncertainty << reference_.end << reference_.methods;
  fmt::print("\n{}: {} = {:.13f}, reference good to {:.0e} ({})\n", scene_.name,
             moves_ ? "e" : "strain", reference_.outcome.answer, reference_.uncertainty,
             reference_.methods);
}

const TimedScene* ScenePrecision::best(double error,
                                       const std::function<bool(const TimedScene&)>& chosen) const {
  std::vector<WorkAndError> points;
  for (const TimedScene& one : all_) {
    const bool counts = one.until() == Until::kAnswer && one.scene().numerics.error == error;
    points.push_back({one.median_time(), counts && chosen(one) ? error_of(one) : Outcome::kNaN});
  }
  const auto k = least_work(points, error);
  return k ? &all_[*k] : nullptr;
}

std::string setting_of(const TimedScene& one) {
  const Scene::Numerics& numerics = one.scene().numerics;
  if (numerics.tolerance) return fmt::format("tolerance {:g}", *numerics.tolerance);
  if (is_adaptive(one.outcome().integrator) ||
      one.outcome().integrator == IntegratorKind::kNewton) {
    return "auto";
  }
  return fmt::format("step {:.4g}", one.outcome().step);
}

/// Integrator, setting, time and true error.
std::string add_choice(const TimedScene* one, double error, Table& table) {
  if (one == nullptr) {
    table << "none"
          << "" << Outcome::kNaN << Outcome::kNaN;
    return "none";
  }
  const std::string name = name_of(one->outcome().integrator);
  table << name << setting_of(*one) << one->median_time() << error;
  return fmt::format("{} {} {:.4f} s", name, setting_of(*one), one->median_time());
}

void ScenePrecision::add_best(Table& table) const {
  const auto is_auto = [](const TimedScene& one) {
    return one.scene().numerics.integrator == IntegratorKind::kAuto;
  };
  fmt::print("\n| error | bare | verified | auto | auto/verified | auto/bare |\n");
  fmt::print("|---|---|---|---|---|---|\n");
  for (const double error : effort_.errors()) {
    const TimedScene* const bare = best(error, [&](const auto& one) { return !one.is_verified(); });
    const TimedScene* const verified =
        best(error, [&](const auto& one) { return one.is_verified() && !is_auto(one); });
    const TimedScene* const automatic = best(error, [&](const auto& one) { return is_auto(one); });
    const auto ratio_to = [&](const TimedScene* other) {
      return automatic != nullptr && other != nullptr
                 ? automatic->median_time() / other->median_time()
                 : Outcome::kNaN;
    };
    table << scene_.name << error;
    std::string line = fmt::format("| {:.0e} ", error);
    for (const TimedScene* const one : {bare, verified, automatic}) {
      line += "| " + add_choice(one, one != nullptr ? error_of(*one) : Outcome::kNaN, table) + " ";
    }
    table << ratio_to(verified) << ratio_to(bare);
    fmt::print("{}| {:.2f} | {:.2f} |\n", line, ratio_to(verified), ratio_to(bare));
  }
}

}  // namespace

void measure_scenes(const WorkPrecision& task) {
  Table references({"scene", "answer", "uncertainty", "position_uncertainty", "end", "methods"});
  Table best({"scene", "wanted_error", "bare_integrator", "bare_setting", "bare_time", "bare_error",
              "verified_integrator", "verified_setting", "verified_time", "verified_error",
              "auto_integrator", "auto_setting", "auto_time", "auto_error", "auto_by_verified",
              "auto_by_bare"});
  const std::vector<TestScene> scenes = test_scenes(task.quick);
  ProgressBar bar("work_precision", scenes.size(), "scenes");
  std::size_t done = 0;
  for (const TestScene& scene : scenes) {
    bar.show(done++);
    ScenePrecision precision(scene, task.effort);
    precision.measure();
    bar.clear();
    precision.write(task.folder);
    precision.add_reference(references);
    precision.add_best(best);
    references.write(task.folder / "references.csv");
    best.write(task.folder / "best_for_error.csv");
    std::fflush(stdout);
  }
}

}  // namespace impact
