#include "tools/side_by_side.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <memory>
#include <tuple>
#include <utility>

#include "lattice/input_error.hpp"
#include "mechanics/lane_bundle.hpp"
#include "run/compose.hpp"
#include "run/energy_monitor.hpp"
#include "tools/experiment.hpp"

namespace impact {
namespace {

constexpr int kMostPoints = 30000;  // see README, Speed
constexpr int kCheckSteps = 64;

/// A scene on its way to its answer.
struct Candidate {
  std::size_t place;  ///< of the scene
  LaneMotion* motion = nullptr;
  std::unique_ptr<Experiment> experiment{};
  double wall_time = 0.0;  ///< s
  std::string failure{};   ///< why it cannot go on
};

/// What motions must have in common to be in one bundle.
struct Company {
  IntegratorKind integrator;
  LaneField::Kind kind;
  bool needs_common_step;
  double step;  ///< R/c; 0 where it does not matter
  double eta;   ///< M c/R; 0 where it does not matter

  auto keys() const { return std::tie(integrator, kind.cubic, kind.damped, step, eta); }
  bool operator<(const Company& other) const { return keys() < other.keys(); }
};

Company company_of(const Candidate& candidate) {
  const IntegratorKind integrator = candidate.experiment->resolution().integrator;
  const ForceField& field = candidate.motion->field();
  const LaneField::Kind kind = LaneField::kind_of(field);
  const bool solves = kind.damped && (integrator == IntegratorKind::kImplicitDamping ||
                                      integrator == IntegratorKind::kExtrapolatedDamping);
  return {integrator, kind, solves, solves ? candidate.motion->step_size() : 0.0,
          solves ? field.bonds.law().eta : 0.0};
}

class SideBySide {
 public:
  SideBySide(const std::vector<Scene>& scenes, const std::function<bool()>& stop,
             const std::function<void()>& done)
      : scenes_(scenes),
        stop_(stop),
        done_(done),
        outcome_{std::vector<ResultTexts>(scenes.size())} {
    const auto damped = std::find_if(scenes.begin(), scenes.end(),
                                     [](const Scene& scene) { return scene.is_damped(); });
    bodies_ = make_bodies(damped != scenes.end() ? *damped : scenes.front());
    try {
      for (std::size_t i = 0; i < scenes.size(); ++i) start(i);
    } catch (const InputError&) {
      outcome_.error = std::current_exception();
      outcome_.results.resize(candidates_.size());
    }
  }

  std::optional<Outcome> run() {
    while (!waiting_.empty()) {
      const auto most = std::max_element(
          waiting_.begin(), waiting_.end(),
          [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
      if (!advance(most->first)) return std::nullopt;
    }
    return std::move(outcome_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void start(std::size_t place) {
    const auto begin = Clock::now();
    const auto composition = std::make_shared<const Composition>(compose(scenes_[place], bodies_));
    Candidate& candidate = candidates_.emplace_back(Candidate{place});
    candidate.experiment = std::make_unique<Experiment>(
        scenes_[place], composition,
        [&candidate](const Composition& start, const Resolution& resolution) {
          auto motion = std::make_unique<LaneMotion>(start.field, start.initial,
                                                     start.rates.lattice, resolution.step);
          candidate.motion = motion.get();
          return motion;
        });
    candidate.wall_time += std::chrono::duration<double>(Clock::now() - begin).count();
    wait(candidate);
  }

  void wait(Candidate& candidate) { waiting_[company_of(candidate)].push_back(&candidate); }

  /// Until nobody waits for this company any more. False when told to stop.
  bool advance(const Company company) {
    LaneBundle bundle(
        bodies_->disk, 1.0 / static_cast<double>(bodies_->disk.points.rows()), company.kind,
        [&] { return make_fixed<LaneField>(company.integrator); }, company.needs_common_step);
    std::deque<Candidate*>& queue = waiting_[company];
    since_ = Clock::now();
    for (int step = 1;; ++step) {
      if (!queue.empty() && !bundle.is_full()) {
        share_time();
        for (; !queue.empty() && !bundle.is_full(); queue.pop_front()) {
          on_board_.push_back(queue.front());
          bundle.board(*queue.front()->motion);
        }
      }
      if (on_board_.empty()) break;
      bundle.step();
      const auto departed = std::partition(on_board_.begin(), on_board_.end(), stays);
      if (departed != on_board_.end()) {
        share_time();
        std::for_each(departed, on_board_.end(), [&](Candidate* one) { send_on(*one); });
        on_board_.erase(departed, on_board_.end());
      }
      if (step % kCheckSteps == 0 && stop_()) return false;
    }
    waiting_.erase(company);
    return true;
  }

  /// Looks at the step that was made. False when the candidate cannot stay in its lane.
  static bool stays(Candidate* candidate) {
    const LaneMotion* const motion = candidate->motion;
    if (!motion->is_on_board()) return false;
    try {
      candidate->experiment->observe_step();
    } catch (const RunFailure& failure) {
      candidate->failure = failure.what();
      return false;
    }
    return !candidate->experiment->finished() && candidate->motion == motion;
  }

  void send_on(Candidate& candidate) {
    if (!candidate.failure.empty()) {
      outcome_.results[candidate.place] = failure(candidate.failure);
    } else if (candidate.experiment->finished()) {
      candidate.experiment->set_wall_time(candidate.wall_time);
      outcome_.results[candidate.place] = texts_of(*candidate.experiment);
    } else {
      wait(candidate);
      return;
    }
    candidate.experiment.reset();
    done_();
  }

  void share_time() {
    const auto now = Clock::now();
    const double time = std::chrono::duration<double>(now - since_).count();
    for (Candidate* const candidate : on_board_) {
      candidate->wall_time += time / static_cast<double>(on_board_.size());
    }
    since_ = now;
  }

  const std::vector<Scene>& scenes_;
  const std::function<bool()>& stop_;
  const std::function<void()>& done_;
  std::shared_ptr<const Bodies> bodies_;
  std::deque<Candidate> candidates_;
  std::map<Company, std::deque<Candidate*>> waiting_;
  std::vector<Candidate*> on_board_;
  Clock::time_point since_;  ///< time is shared out up to here
  Outcome outcome_;
};

std::string text(const YAML::Node& value) {
  if (value.IsScalar()) return value.Scalar();
  return fmt::format("{}", fmt::join(value.as<std::vector<std::string>>(), ";"));
}

}  // namespace

ResultTexts texts_of(const Experiment& experiment) {
  ResultTexts texts;
  for (const auto& entry : experiment.result()) texts[entry.first.Scalar()] = text(entry.second);
  return texts;
}

bool can_be_in_lanes(const Scene& scene) {
  return scene.kind == SceneKind::kCollision && scene.wall.kind == WallKind::kPotential &&
         !is_adaptive(scene.numerics.integrator) && scene.disk.recipe.points <= kMostPoints;
}

std::optional<Outcome> simulate_side_by_side(const std::vector<Scene>& scenes,
                                             const std::function<bool()>& stop,
                                             const std::function<void()>& done) {
  return SideBySide(scenes, stop, done).run();
}

}  // namespace impact
