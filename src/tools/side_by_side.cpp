#include "tools/side_by_side.hpp"

#include <fmt/ranges.h>

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
#include "mechanics/equilibrium_solver.hpp"
#include "mechanics/lane_bundle.hpp"
#include "run/compose.hpp"
#include "run/energy_monitor.hpp"

namespace impact {
namespace {

/// With more points the memory is too slow for lanes, as bench_runs measures.
constexpr Eigen::Index kMostPoints = 20000;
/// A step of as many searches for equilibrium in lanes takes as long as one of so many single ones.
constexpr std::size_t kFewestSearches = 3;
constexpr int kCheckSteps = 64;
/// Time of a step of a bundle, in steps of one run, as test/bench/compare_lammps and bench_runs
/// measure it.
constexpr double kBundleStep = 5.5;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

struct Candidate;

/// A run in lanes. It belongs to its candidate, to be there when the experiment asks for it, or
/// since it did to the experiment.
struct Ride {
  Candidate* candidate;
  Resolution resolution;
  LaneMotion* motion;
  std::optional<Run> run;  ///< until the experiment asks for it
  bool cancelled = false;
};

/// A scene on its way to its answer, by rides or, if it is static, by a search.
struct Candidate {
  std::size_t place;  ///< of the scene
  std::shared_ptr<const Composition> composition;
  EquilibriumSearch* search = nullptr;
  std::deque<Ride> rides{};
  Ride* present = nullptr;    ///< of the experiment's run
  std::deque<Ride*> ahead{};  ///< of the runs that will be asked for next, in their order
  std::unique_ptr<Experiment> experiment{};
  double wall_time = 0.0;  ///< s
  std::string failure{};   ///< why it cannot go on
};

/// What motions must have in common to be in one bundle, besides their bodies.
struct Company {
  IntegratorKind integrator;
  LaneField::Kind kind;
  bool needs_common_step;
  double step;  ///< R/c; 0 where it does not matter
  double eta;   ///< M c/R; 0 where it does not matter

  auto keys() const { return std::tie(integrator, kind.cubic, kind.damped, step, eta); }
  bool operator<(const Company& other) const { return keys() < other.keys(); }
};

Company company_of(const Ride& ride) {
  const IntegratorKind integrator = ride.resolution.integrator;
  const ForceField& field = ride.motion->field();
  const LaneField::Kind kind = LaneField::kind_of(field);
  const bool solves = kind.damped && solves_for_damping(integrator);
  return {integrator, kind, solves, solves ? ride.motion->step_size() : 0.0,
          solves ? field.bonds.law().eta : 0.0};
}

/// About how many steps a run of the scene takes.
double expected_steps(const Composition& composition) {
  return composition.expected_time / composition.resolution.step;
}

class SideBySide {
 public:
  SideBySide(const std::vector<Scene>& scenes, std::shared_ptr<const Bodies> bodies,
             const std::function<bool()>& stop, const std::function<void()>& done)
      : scenes_(scenes), stop_(stop), done_(done), bodies_(std::move(bodies)) {
    lattice_ = bodies_->wall ? joined(bodies_->disk, bodies_->wall->lattice) : bodies_->disk;
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
    outcome_.in_lanes =
        lattice_.points.rows() <= kMostPoints && candidates_.size() >= kFewestSearches;
    return outcome_.in_lanes ? solve_by<LaneEquilibriumSolver>() : solve_by<EquilibriumSolver>();
  }

  template <class Solver>
  bool solve_by() {
    Solver solver;
    typename Solver::Searches searches{};
    std::array<Candidate*, Solver::kSearches> on_board{};
    auto next = candidates_.begin();
    for (;;) {
      since_ = Clock::now();
      for (std::size_t lane = 0; lane < searches.size() && next != candidates_.end(); ++lane) {
        if (on_board[lane] != nullptr) continue;
        on_board[lane] = &*next++;
        searches[lane] = start_search(*on_board[lane]);
      }
      const auto taken = searches.size() - static_cast<std::size_t>(std::count(
                                               on_board.begin(), on_board.end(), nullptr));
      if (taken == 0) return true;
      solver.advance(searches);
      const double time = seconds_since(since_) / static_cast<double>(taken);
      for (std::size_t lane = 0; lane < searches.size(); ++lane) {
        if (on_board[lane] == nullptr) continue;
        on_board[lane]->wall_time += time;
        if (observe_search(*on_board[lane])) continue;
        on_board[lane] = nullptr;
        searches[lane] = nullptr;
      }
      if (stop_()) return false;
    }
  }

  EquilibriumSearch* start_search(Candidate& candidate) {
    candidate.experiment = std::make_unique<Experiment>(
        scenes_[candidate.place], candidate.composition,
        [this, &candidate](const Resolution& resolution) {
          const Scene& scene = scenes_[candidate.place];
          auto search = make_search(scene, *candidate.composition);
          candidate.search = search.get();
          return Run(scene, candidate.composition, resolution, std::move(search));
        });
    return candidate.search;
  }

  /// Looks at the step that was made. False when it was the last one.
  bool observe_search(Candidate& candidate) {
    const auto begin = Clock::now();
    try {
      candidate.experiment->observe_step();
      if (!candidate.experiment->finished()) return true;
    } catch (const RunFailure& failure) {
      candidate.failure = failure.what();
    }
    candidate.wall_time += seconds_since(begin);
    conclude(candidate);
    return false;
  }

  /// False when told to stop.
  bool move() {
    outcome_.in_lanes = lanes_pay();
    return outcome_.in_lanes ? run_in_lanes() : run_singly();
  }

  /// Whether so many lanes will be taken for so long that a bundle is faster than single runs.
  /// Since the results are the same to the last bit, this changes nothing but the time.
  bool lanes_pay() const {
    double all = 0.0;
    double longest = 0.0;
    for (const Candidate& candidate : candidates_) {
      const double steps = expected_steps(*candidate.composition);
      const double runs = scenes_[candidate.place].numerics.are_given() ? 1.0 : kStepsOfAllRuns;
      all += runs * steps;
      longest = std::max(longest, steps);
    }
    return lattice_.points.rows() <= kMostPoints &&
           kBundleStep * std::max(longest, all / kLanes) < all;
  }

  bool run_singly() {
    for (Candidate& candidate : candidates_) {
      const auto begin = Clock::now();
      try {
        Experiment& experiment = *(candidate.experiment = std::make_unique<Experiment>(
                                       scenes_[candidate.place], candidate.composition));
        while (!experiment.finished()) {
          if (stop_()) return false;
          experiment.advance(stop_);
        }
      } catch (const RunFailure& failure) {
        candidate.failure = failure.what();
      }
      candidate.wall_time += seconds_since(begin);
      conclude(candidate);
    }
    return true;
  }

  bool run_in_lanes() {
    for (Candidate& candidate : candidates_) start(candidate);
    while (!waiting_.empty()) {
      const auto most = std::max_element(
          waiting_.begin(), waiting_.end(),
          [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
      if (!advance(most->first)) return false;
    }
    return true;
  }

  /// Sets out for the first run and for those after it, as far as they are foreseen.
  void start(Candidate& candidate) {
    const auto begin = Clock::now();
    candidate.experiment =
        std::make_unique<Experiment>(scenes_[candidate.place], candidate.composition,
                                     [this, &candidate](const Resolution& resolution) {
                                       return next_run(candidate, resolution);
                                     });
    for (const Resolution& later : candidate.experiment->later_resolutions()) {
      candidate.ahead.push_back(&new_ride(candidate, later));
    }
    candidate.wall_time += seconds_since(begin);
  }

  Ride& new_ride(Candidate& candidate, const Resolution& resolution) {
    const Composition& composition = *candidate.composition;
    auto motion = std::make_unique<LaneMotion>(composition.field, start_of(composition, resolution),
                                               composition.rates.lattice, resolution.step);
    LaneMotion* const in_lane = motion.get();
    Run run(scenes_[candidate.place], candidate.composition, resolution, std::move(motion));
    candidate.rides.push_back({&candidate, resolution, in_lane, std::move(run)});
    wait(candidate.rides.back());
    return candidate.rides.back();
  }

  /// The run that the experiment asks for: the one that went ahead, or else a new one.
  Run next_run(Candidate& candidate, const Resolution& resolution) {
    if (!candidate.ahead.empty() && !(candidate.ahead.front()->resolution == resolution)) {
      cancel(candidate);
    }
    if (candidate.ahead.empty()) {
      candidate.present = &new_ride(candidate, resolution);
    } else {
      candidate.present = candidate.ahead.front();
      candidate.ahead.pop_front();
    }
    Run run = std::move(*candidate.present->run);
    candidate.present->run.reset();
    return run;
  }

  static void cancel(Candidate& candidate) {
    for (Ride* const ride : candidate.ahead) ride->cancelled = true;
    candidate.ahead.clear();
  }

  void wait(Ride& ride) { waiting_[company_of(ride)].push_back(&ride); }

  /// Until nobody waits for this company any more. False when told to stop.
  bool advance(const Company company) {
    LaneBundle bundle(
        lattice_, 1.0 / static_cast<double>(bodies_->disk.points.rows()), company.kind,
        [&] { return make_fixed<LaneField>(company.integrator); }, company.needs_common_step);
    std::deque<Ride*>& queue = waiting_[company];
    since_ = Clock::now();
    for (int step = 1;; ++step) {
      if (!queue.empty() && !bundle.is_full()) fill(bundle, queue);
      if (on_board_.empty()) break;
      bundle.step();
      const auto departed = std::partition(on_board_.begin(), on_board_.end(), stays);
      if (departed != on_board_.end()) {
        share_time();
        std::for_each(departed, on_board_.end(), [&](Ride* ride) { send_on(*ride, bundle); });
        on_board_.erase(departed, on_board_.end());
      }
      if (step % kCheckSteps == 0 && stop_()) return false;
    }
    waiting_.erase(company);
    return true;
  }

  void fill(LaneBundle& bundle, std::deque<Ride*>& queue) {
    share_time();
    for (; !queue.empty() && !bundle.is_full(); queue.pop_front()) {
      Ride& ride = *queue.front();
      if (ride.cancelled) {
        ride.run.reset();
        continue;
      }
      bundle.board(*ride.motion);
      on_board_.push_back(&ride);
    }
  }

  /// Looks at the step that was made. False when the ride ends here or has to change.
  static bool stays(Ride* ride) {
    if (ride->cancelled || !ride->motion->is_on_board()) return false;
    Candidate& candidate = *ride->candidate;
    try {
      if (ride->run) {
        ride->run->observe_step();
        return !ride->run->finished();
      }
      candidate.experiment->observe_step();
    } catch (const RunFailure& failure) {
      if (ride->run) {
        cancel(candidate);  // it will fail again if it is asked for
      } else {
        candidate.failure = failure.what();
      }
      return false;
    }
    return !candidate.experiment->finished() && candidate.present == ride;
  }

  void send_on(Ride& ride, LaneBundle& bundle) {
    Candidate& candidate = *ride.candidate;
    if (ride.cancelled) {
      ride.run.reset();
    } else if (ride.run) {
      if (ride.run->finished()) {
        bundle.leave(*ride.motion);
      } else {
        wait(ride);
      }
    } else if (!candidate.failure.empty() || candidate.experiment->finished()) {
      cancel(candidate);
      conclude(candidate);
    } else if (candidate.present == &ride) {
      wait(ride);
    }
  }

  void conclude(Candidate& candidate) {
    if (candidate.failure.empty()) {
      candidate.experiment->set_wall_time(candidate.wall_time);
      outcome_.results[candidate.place] = texts_of(*candidate.experiment);
    } else {
      outcome_.results[candidate.place] = failure(candidate.failure);
    }
    candidate.experiment.reset();
    candidate.composition.reset();
    done_();
  }

  void share_time() {
    const double time = seconds_since(since_);
    for (Ride* const ride : on_board_) {
      ride->candidate->wall_time += time / static_cast<double>(on_board_.size());
    }
    since_ = Clock::now();
  }

  const std::vector<Scene>& scenes_;
  const std::function<bool()>& stop_;
  const std::function<void()>& done_;
  std::shared_ptr<const Bodies> bodies_;
  Lattice lattice_;  ///< of all points
  std::deque<Candidate> candidates_;
  std::map<Company, std::deque<Ride*>> waiting_;
  std::vector<Ride*> on_board_;
  Clock::time_point since_;  ///< time is shared out up to here
  SeriesOutcome outcome_;
};

std::string text(const YAML::Node& value) {
  if (value.IsScalar()) return cell_text(value);
  return fmt::format("{}", fmt::join(value.as<std::vector<std::string>>(), ";"));
}

}  // namespace

ResultTexts texts_of(const Experiment& experiment) {
  ResultTexts texts;
  for (const auto& entry : experiment.result()) texts[entry.first.Scalar()] = text(entry.second);
  return texts;
}

bool can_be_in_lanes(const Scene& scene) {
  if (scene.is_static()) return true;
  const bool known = scene.wall.kind == WallKind::kPotential || !scene.is_damped();
  return scene.kind == SceneKind::kCollision && known && !is_adaptive(scene.numerics.integrator);
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
