#include "verification/timed_scene.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numeric>
#include <utility>

#include "fits/statistics.hpp"
#include "kernels/threads.hpp"
#include "mechanics/motion.hpp"
#include "output/interruption.hpp"
#include "run/make_integrator.hpp"
#include "scene/scene_parameters.hpp"
#include "series/convergence_study.hpp"

namespace impact {
namespace {

using Stop = std::function<bool()>;

void take_run(const Run& run, Outcome& outcome) {
  outcome.position = run.disk_state().position;
  outcome.energy_error = run.energy_error();
  outcome.evaluations = static_cast<double>(run.system().field().evaluations);
  outcome.step = run.system().step_size();
  outcome.integrator = run.integrator();
  outcome.flags = fmt::format("{}", fmt::join(run.flags(), ";"));
}

void throw_if(const Stop& stop) {
  if (stop()) throw RunFailure("takes too long");
}

/// e of a run up to a time at which the disk has left the wall.
Outcome run_to_time(const Scene& scene, const Stop& stop) {
  Run run(scene);
  run.advance(stop);
  throw_if(stop);
  if (run.system().halvings() > 0) throw RunFailure("the wall is too stiff for this step");
  Outcome outcome;
  take_run(run, outcome);
  outcome.answer = run.disk_state().velocity.col(1).mean() / scene.impact.normal_velocity();
  return outcome;
}

Outcome run_to_answer(const Scene& scene, const Stop& stop) {
  ConvergenceStudy study(scene);
  while (!study.finished()) {
    throw_if(stop);
    study.advance(stop);
  }
  Outcome outcome;
  take_run(study.run(), outcome);
  outcome.estimated_error = study.estimated_error();
  outcome.answer = study.answer();
  return outcome;
}

Outcome outcome_of(const Scene& scene, Until until, const Stop& stop) {
  return until == Until::kTime ? run_to_time(scene, stop) : run_to_answer(scene, stop);
}

/// Without what a table cannot hold.
std::string in_one_cell(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ',' || c == '\n'; }, ';');
  return text;
}

}  // namespace

void throw_if_interrupted() {
  if (interrupted()) throw std::runtime_error("interrupted");
}

void TimedScene::run(double longest) {
  threads_in_a_run() = 1;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point wall_start = Clock::now();
  const std::clock_t start = std::clock();
  const auto time = [&] { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; };
  try {
    outcome_ = outcome_of(scene_, until_, [&] { return time() > longest; });
  } catch (const std::runtime_error& error) {
    outcome_ = {};
    outcome_.flags = in_one_cell(error.what());
  }
  times_.push_back(time());
  wall_times_.push_back(std::chrono::duration<double>(Clock::now() - wall_start).count());
}

bool TimedScene::is_verified() const {
  return until_ == Until::kAnswer && !scene_.numerics.are_given();
}

double TimedScene::spent() const { return std::accumulate(times_.begin(), times_.end(), 0.0); }

double TimedScene::median_time() const { return median(times_); }

double TimedScene::median_wall_time() const { return median(wall_times_); }

std::vector<double> Effort::errors() const {
  std::vector<double> list;
  for (int power = first_power; power <= last_power; ++power) {
    list.push_back(std::pow(10.0, -power));
  }
  return list;
}

void repeat_in_turn(std::vector<TimedScene>& timed, const Effort& effort) {
  for (int round = 1; round < effort.rounds; ++round) {
    for (std::size_t i = 0; i < timed.size(); ++i) {
      throw_if_interrupted();
      const bool backwards = round % 2 == 1;
      TimedScene& timed_scene = timed[backwards ? timed.size() - 1 - i : i];
      if (timed_scene.has_answer() && timed_scene.spent() < effort.most) {
        timed_scene.run(2.0 * effort.longest);
      }
    }
  }
}

Outcome outcome_of(const Scene& scene, Until until) {
  return outcome_of(scene, until, [] { return false; });
}

bool can_have(Scene scene, IntegratorKind integrator) {
  scene.numerics.integrator = integrator;
  try {
    parse_scene(flatten(YAML::Load(to_yaml(scene))));
    return true;
  } catch (const InputError&) {
    return false;
  }
}

IntegratorKind most_exact(const Scene& scene) {
  IntegratorKind best = IntegratorKind::kVerlet;
  for (const IntegratorTraits& method : kIntegrators) {
    if (is_automatic(method, scene.circumstances()) && method.order > order_of(best)) {
      best = method.kind;
    }
  }
  return best;
}

double longest_step(Scene scene, IntegratorKind integrator) {
  constexpr double kMargin = 0.96;
  scene.numerics = {};
  const Rates rates = compose(scene).rates;
  return kMargin * step_limit(integrator, rates.lattice, rates.wall,
                              Motion::inner_share(scene.wall.a, rates.spacing));
}

}  // namespace impact
