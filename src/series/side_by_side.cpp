#include "series/side_by_side.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

#include "lattice/input_error.hpp"
#include "mechanics/lane_bundle.hpp"
#include "run/compose.hpp"
#include "run/energy_monitor.hpp"
#include "run/make_integrator.hpp"
#include "statics/equilibrium_solver.hpp"
#include "statics/large_equilibrium_solver.hpp"

namespace impact {
namespace {

/// With more points the memory is too slow for lanes, as bench_runs measures.
constexpr Eigen::Index kMostPoints = 20000;
/// A step of a full bundle of searches for equilibrium takes as long as a step of this many single
/// ones.
constexpr std::size_t kFewestSearches = 3;
constexpr int kStepsBetweenChecks = 64;
/// Above so many runs a step of a bundle takes less time than one of each by itself, as sweeps of 8
/// to 16 speeds have it; and where the methods solve for damped velocities.
constexpr std::size_t kMostSingles = 5;
constexpr std::size_t kMostSinglesThatSolve = 3;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

struct Candidate;

/// A run in lanes. It starts before the study asks for it; until then its candidate keeps the
/// Run, afterwards the study does.
struct LaneRun {
  Candidate* candidate;
  Resolution resolution;
  LaneMotion* motion;
  std::optional<Run> run;  ///< until the study asks for it
  bool cancelled = false;
};

/// A scene on its way to its answer, by runs in lanes or, if it is static, by a search.
struct Candidate {
  std::size_t place;  ///< of the scene
  std::shared_ptr<const Composition> composition;
  EquilibriumSearch* search = nullptr;
  std::deque<LaneRun> lane_runs{};
  LaneRun* present = nullptr;    ///< of the study's run
  std::deque<LaneRun*> ahead{};  ///< of the runs that will be asked for next, in their order
  std::unique_ptr<ConvergenceStudy> study{};
  double wall_time = 0.0;  ///< s
  std::string failure{};   ///< why it cannot go on
};

/// What motions must have in common to be in one bundle, besides their bodies.
struct BundleKey {
  IntegratorKind integrator;
  LaneField::Kind kind;
  bool needs_common_step;
  double step;     ///< R/c; 0 where it does not matter
  double eta;      ///< M c/R; 0 where it does not matter
  bool supported;  ///< false where it does not matter

  auto keys() const { return std::tie(integrator, kind.cubic, kind.damped, step, eta, supported); }
  bool operator<(const BundleKey& other) const { return keys() < other.keys(); }
};

BundleKey bundle_key_of(const LaneRun& lane_run) {
  const IntegratorKind integrator = lane_run.resolution.integrator;
  const ForceField& field = lane_run.motion->field();
  const LaneField::Kind kind = LaneField::kind_of(field);
  const bool solves = kind.damped && solves_for_damping(integrator);
  return {integrator,
          kind,
          solves,
          solves ? lane_run.motion->step_size() : 0.0,
          solves ? field.bonds.law().eta : 0.0,
          solves && field.supports.has_value()};
}

/// Whether lanes take the method and the field of the first run, and so those of all.
bool are_for_lanes(const Composition& composition) {
  return traits_of(composition.resolution.integrator).in_lanes &&
         LaneField::knows(composition.field);
}

/// Whether as many runs are faster in a bundle than one by one.
bool fill_a_bundle(std::size_t runs, const BundleKey& key) {
  return runs > (key.needs_common_step ? kMostSinglesThatSolve : kMostSingles);
}

class SideBySide {
 public:
  SideBySide(const std::vector<Scene>& scenes, std::shared_ptr<const Bodies> bodies,
             const std::function<bool()>& stop, const std::function<void()>& done)
      : scenes_(scenes), stop_(stop), done_(done), bodies_(std::move(bodies)) {
    lattice_ = bodies_->joined();
    try {
      for (std::size_t i = 0; i < scenes.size(); ++i) {
        const auto begin = Clock::now();
        auto composition = std::make_shared<const Composition>(compose(scenes[i], bodies_));
        candidates_.push_back({i, std::move(composition)});
        candidates_.back().wall_time = seconds_since(begin);
      }
    } catch (const InputError&) {
      outcome_.error = std::current_exception();
    }
    outcome_.results.resize(candidates_.size());
  }

  std::optional<SeriesOutcome> run() {
    if (!(scenes_.front().is_static() ? solve() : move())) return std::nullopt;
    return std::move(outcome_);
  }

 private:
  /// Goes to the states at rest. False when told to stop.
  bool solve() {
    if (LargeEquilibriumSolver::is_for(lattice_.points.rows())) {
      return solve_by<LargeEquilibriumSolver>();
    }
    outcome_.in_lanes = candidates_.size() >= kFewestSearches;
    return outcome_.in_lanes ? solve_by<LaneEquilibriumSolver>() : solve_by<EquilibriumSolver>();
  }

  template <class Solver>
  bool solve_by() {
    Solver solver;
    typename Solver::Searches searches{};
    std::array<Candidate*, Solver::kSearches> in_lanes{};
    auto next = candidates_.begin();
    for (;;) {
      since_ = Clock::now();
      for (std::size_t lane = 0; lane < searches.size() && next != candidates_.end(); ++lane) {
        if (in_lanes[lane] != nullptr) continue;
        in_lanes[lane] = &*next++;
        searches[lane] = start_search(*in_lanes[lane]);
      }
      const auto taken = searches.size() - static_cast<std::size_t>(std::count(
                                               in_lanes.begin(), in_lanes.end(), nullptr));
      if (taken == 0) return true;
      solver.advance(searches);
      const double time = seconds_since(since_) / static_cast<double>(taken);
      for (std::size_t lane = 0; lane < searches.size(); ++lane) {
        if (in_lanes[lane] == nullptr) continue;
        in_lanes[lane]->wall_time += time;
        if (!searches[lane]->finished()) continue;
        conclude_search(*in_lanes[lane]);
        in_lanes[lane] = nullptr;
        searches[lane] = nullptr;
      }
      if (stop_()) return false;
    }
  }

  EquilibriumSearch* start_search(Candidate& candidate) {
    candidate.study = std::make_unique<ConvergenceStudy>(
        scenes_[candidate.place], candidate.composition,
        [this, &candidate](const Resolution& resolution) {
          const Scene& scene = scenes_[candidate.place];
          auto search = make_search(scene, *candidate.composition);
          candidate.search = search.get();
          return Run(scene, candidate.composition, resolution, {std::move(search)});
        });
    return candidate.search;
  }

  void conclude_search(Candidate& candidate) {
    const auto begin = Clock::now();
    try {
      candidate.study->observe_solution(*candidate.search);
    } catch (const RunFailure& failure) {
      candidate.failure = failure.what();
    }
    candidate.wall_time += seconds_since(begin);
    conclude(candidate);
  }

  /// False when told to stop.
  bool move() {
    std::vector<Candidate*> for_lanes;
    std::vector<Candidate*> singles;
    for (Candidate& candidate : candidates_) {
      (are_for_lanes(*candidate.composition) ? for_lanes : singles).push_back(&candidate);
    }
    return run_singly(singles) &&
           (lattice_.points.rows() > kMostPoints ? run_singly(for_lanes) : run_in_lanes(for_lanes));
  }

  bool run_singly(const std::vector<Candidate*>& candidates) {
    for (Candidate* const next : candidates) {
      Candidate& candidate = *next;
      const auto begin = Clock::now();
      try {
        ConvergenceStudy& study = *(candidate.study = std::make_unique<ConvergenceStudy>(
                                        scenes_[candidate.place], candidate.composition));
        while (!study.finished()) {
          if (stop_()) return false;
          study.advance(stop_);
        }
      } catch (const RunFailure& failure) {
        candidate.failure = failure.what();
      }
      candidate.wall_time += seconds_since(begin);
      conclude(candidate);
    }
    return true;
  }

  bool run_in_lanes(const std::vector<Candidate*>& candidates) {
    for (Candidate* const candidate : candidates) start(*candidate);
    for (auto& [key, queue] : waiting_) put_finest_first(queue);
    while (!waiting_.empty()) {
      const auto most = std::max_element(
          waiting_.begin(), waiting_.end(),
          [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
      if (!advance(most->first)) return false;
    }
    return true;
  }

  /// Of each scene, since it is the longest: so the runs that are left over at the end, when other
  /// lanes have nothing to do, are short ones.
  static void put_finest_first(std::deque<LaneRun*>& queue) {
    const auto key = [](const LaneRun* run) {
      return std::make_pair(run->candidate->place, run->resolution.step);
    };
    std::stable_sort(queue.begin(), queue.end(),
                     [&](const LaneRun* a, const LaneRun* b) { return key(a) < key(b); });
  }

  /// Starts the first run, and those after it as far as they are sure to be needed.
  void start(Candidate& candidate) {
    const auto begin = Clock::now();
    candidate.study =
        std::make_unique<ConvergenceStudy>(scenes_[candidate.place], candidate.composition,
                                           [this, &candidate](const Resolution& resolution) {
                                             return next_run(candidate, resolution);
                                           });
    for (const Resolution& later : candidate.study->later_resolutions()) {
      candidate.ahead.push_back(&new_lane_run(candidate, later));
    }
    candidate.wall_time += seconds_since(begin);
  }

  LaneRun& new_lane_run(Candidate& candidate, const Resolution& resolution) {
    const Composition& composition = *candidate.composition;
    auto motion = std::make_unique<LaneMotion>(composition.field, start_of(composition, resolution),
                                               composition.rates.lattice, resolution.step,
                                               make_fixed<ForceField>(resolution.integrator));
    LaneMotion* const in_lane = motion.get();
    Run run(scenes_[candidate.place], candidate.composition, resolution, {std::move(motion)});
    candidate.lane_runs.push_back({&candidate, resolution, in_lane, std::move(run)});
    wait(candidate.lane_runs.back());
    return candidate.lane_runs.back();
  }

  /// The run that the study asks for: one that was started ahead, or else a new one.
  Run next_run(Candidate& candidate, const Resolution& resolution) {
    if (!candidate.ahead.empty() && !(candidate.ahead.front()->resolution == resolution)) {
      cancel(candidate);
    }
    if (candidate.ahead.empty()) {
      candidate.present = &new_lane_run(candidate, resolution);
    } else {
      candidate.present = candidate.ahead.front();
      candidate.ahead.pop_front();
    }
    Run run = std::move(*candidate.present->run);
    candidate.present->run.reset();
    return run;
  }

  static void cancel(Candidate& candidate) {
    for (LaneRun* const lane_run : candidate.ahead) lane_run->cancelled = true;
    candidate.ahead.clear();
  }

  void wait(LaneRun& lane_run) { waiting_[bundle_key_of(lane_run)].push_back(&lane_run); }

  /// Advances the runs that wait for such a bundle until none is left. False when told to stop.
  bool advance(const BundleKey key) {
    std::deque<LaneRun*>& queue = waiting_[key];
    while (!queue.empty()) {
      if (!(fill_a_bundle(queue.size(), key) ? advance_in_bundle(key, queue)
                                             : advance_singly(queue))) {
        return false;
      }
    }
    waiting_.erase(key);
    return true;
  }

  /// As long as a bundle is faster than single runs.
  bool advance_in_bundle(const BundleKey& key, std::deque<LaneRun*>& queue) {
    LaneBundle bundle(lattice_, 1.0 / static_cast<double>(bodies_->disk().points.rows()), key.kind,
                      make_fixed<LaneField>(key.integrator), key.needs_common_step);
    outcome_.in_lanes = true;
    since_ = Clock::now();
    for (int step = 1;; ++step) {
      if (!queue.empty() && !bundle.is_full()) fill(bundle, queue);
      if (!fill_a_bundle(in_bundle_.size(), key)) break;
      bundle.step();
      const auto leaving = std::partition(in_bundle_.begin(), in_bundle_.end(), stays);
      if (leaving != in_bundle_.end()) {
        share_time();
        std::for_each(leaving, in_bundle_.end(), [&](LaneRun* lane_run) { send_on(*lane_run); });
        in_bundle_.erase(leaving, in_bundle_.end());
      }
      if (step % kStepsBetweenChecks == 0 && stop_()) return false;
    }
    share_time();
    for (LaneRun* const lane_run : in_bundle_) {
      lane_run->motion->leave();
      queue.push_back(lane_run);
    }
    in_bundle_.clear();
    return true;
  }

  bool advance_singly(std::deque<LaneRun*>& queue) {
    LaneRun& lane_run = *queue.front();
    queue.pop_front();
    since_ = Clock::now();
    do {
      if (lane_run.cancelled) break;
      if (lane_run.motion->steps() % kStepsBetweenChecks == 0 && stop_()) return false;
      lane_run.motion->step();
    } while (goes_on(lane_run));
    lane_run.candidate->wall_time += seconds_since(since_);
    send_on(lane_run);
    return true;
  }

  void fill(LaneBundle& bundle, std::deque<LaneRun*>& queue) {
    share_time();
    for (; !queue.empty() && !bundle.is_full(); queue.pop_front()) {
      LaneRun& lane_run = *queue.front();
      if (lane_run.cancelled) {
        lane_run.run.reset();
        continue;
      }
      bundle.add(*lane_run.motion);
      in_bundle_.push_back(&lane_run);
    }
  }

  /// Observes the step that was made. False when the run ends here or has to go into another
  /// bundle.
  static bool stays(LaneRun* lane_run) {
    return !lane_run->cancelled && lane_run->motion->is_in_bundle() && goes_on(*lane_run);
  }

  /// The same of a run by itself.
  static bool goes_on(LaneRun& lane_run) {
    Candidate& candidate = *lane_run.candidate;
    try {
      if (lane_run.run) {
        lane_run.run->observe_step();
        return !lane_run.run->finished();
      }
      candidate.study->observe_step();
    } catch (const RunFailure& failure) {
      if (lane_run.run) {
        cancel(candidate);  // it will fail again if it is asked for
      } else {
        candidate.failure = failure.what();
      }
      return false;
    }
    return !candidate.study->finished() && candidate.present == &lane_run;
  }

  void send_on(LaneRun& lane_run) {
    Candidate& candidate = *lane_run.candidate;
    if (lane_run.cancelled) {
      lane_run.run.reset();
    } else if (lane_run.run) {
      if (lane_run.run->finished()) {
        lane_run.motion->leave();
      } else {
        wait(lane_run);
      }
    } else if (candidate.study) {  // not concluded by another run that ended at this step
      send_on(candidate, lane_run);
    }
  }

  /// Of a run that the study has asked for.
  void send_on(Candidate& candidate, LaneRun& lane_run) {
    if (!candidate.failure.empty() || candidate.study->finished()) {
      cancel(candidate);
      conclude(candidate);
    } else if (candidate.present == &lane_run) {
      wait(lane_run);
    }
  }

  void conclude(Candidate& candidate) {
    if (candidate.failure.empty()) {
      candidate.study->set_wall_time(candidate.wall_time);
      outcome_.results[candidate.place] = candidate.study->result();
    } else {
      outcome_.results[candidate.place] = failure(candidate.failure);
    }
    candidate.study.reset();
    candidate.composition.reset();
    done_();
  }

  void share_time() {
    const double time = seconds_since(since_);
    for (LaneRun* const lane_run : in_bundle_) {
      lane_run->candidate->wall_time += time / static_cast<double>(in_bundle_.size());
    }
    since_ = Clock::now();
  }

  const std::vector<Scene>& scenes_;
  const std::function<bool()>& stop_;
  const std::function<void()>& done_;
  std::shared_ptr<const Bodies> bodies_;
  Lattice lattice_;  ///< of all points
  std::deque<Candidate> candidates_;
  std::map<BundleKey, std::deque<LaneRun*>> waiting_;
  std::vector<LaneRun*> in_bundle_;
  Clock::time_point since_;  ///< time is shared out up to here
  SeriesOutcome outcome_;
};

}  // namespace

bool may_be_in_lanes(const Scene& scene) {
  if (scene.is_static()) return true;
  const bool has_dashpots = scene.has_elastic_wall() && scene.wall.boundary == Boundary::kViscous;
  return scene.kind == SceneKind::kCollision && !scene.has_own_wall_material() && !has_dashpots &&
         traits_of(scene.numerics.integrator).in_lanes;
}

std::shared_ptr<const Bodies> make_common_bodies(const std::vector<Scene>& scenes) {
  const auto damped = std::find_if(scenes.begin(), scenes.end(),
                                   [](const Scene& scene) { return scene.is_damped(); });
  return make_bodies(damped != scenes.end() ? *damped : scenes.front());
}

std::optional<SeriesOutcome> simulate_side_by_side(const std::vector<Scene>& scenes,
                                                   std::shared_ptr<const Bodies> bodies,
                                                   const std::function<bool()>& stop,
                                                   const std::function<void()>& done) {
  return SideBySide(scenes, std::move(bodies), stop, done).run();
}

}  // namespace impact
