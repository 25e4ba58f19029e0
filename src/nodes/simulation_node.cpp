#include "nodes/simulation_node.hpp"

#include <fmt/format.h>
#include <rosgraph_msgs/Clock.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <utility>

#include "lattice/input_error.hpp"
#include "nodes/checksum.hpp"
#include "nodes/conversions.hpp"
#include "nodes/program.hpp"
#include "nodes/states_of_body.hpp"
#include "run/forecast.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

constexpr std::uint32_t kStatusInterval = 100;     // states
constexpr Eigen::Index kMostPointsKept = 1000000;  // between the check and the runs

/// What the bag of a run may have at most, in bytes, as far as its time is known.
double expected_size(const Scene& scene, const Composition& composition) {
  const auto points = static_cast<double>(composition.initial.position.rows());
  constexpr double kShortest = 1.0 / 1.5;  // of output.period: whole steps nearest to it
  const double states = composition.expected_time / (kShortest * scene.output.period) + 2.0;
  const double samples = scene.output.period / composition.resolution.step + 1.0;
  // x, y, vx, vy, and a force on every fourth point; both messages' other fields, records and
  // index.
  const double state = 37.0 * points + 16.0 * samples + 800.0;
  const double status = 3000.0;
  const double lattice = 70.0 * points;     // three bonds a point
  constexpr double kDefinitions = 60000.0;  // of the messages, with each connection
  return states * (state + status / kStatusInterval) + 3.0 * status + lattice + kDefinitions;
}

Forecast forecast_of(const Scene& scene, const Composition& composition) {
  return forecast(scene, composition.bodies->disk().points.rows(),
                  composition.field.other_points());
}

/// Stamps must differ from one state to the next, and fit into ros::Duration.
void check_stamps(double seconds_per_time_unit, double period, double longest_time) {
  constexpr double kResolution = 1e-8;       // s, ten of ros::Time's nanoseconds
  constexpr double kLargest = 2147483647.0;  // s
  const double low = kResolution / period;
  const double high = kLargest / std::max(longest_time, period);
  if (seconds_per_time_unit < low || seconds_per_time_unit > high) {
    throw bad_value(
        "seconds_per_time_unit", fmt::format("{}", seconds_per_time_unit),
        fmt::format("number in [{:.3g}, {:.3g}] for the stamps of this series", low, high));
  }
}

/// Of the run that has most.
std::size_t most_bodies(const std::vector<Scene>& series) {
  std::size_t most = 1;
  for (const Scene& scene : series) most = std::max(most, 1 + scene.other_bodies());
  return most;
}

double free_space(const std::string& file) {
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  std::error_code error;
  const auto space = std::filesystem::space(folder, error);
  if (error) {
    throw InputError(fmt::format("bag: {} cannot be written: {}", file, error.message()));
  }
  return static_cast<double>(space.available);
}

}  // namespace

Compositions check_series(const SimulationNodeParameters& parameters,
                          const std::vector<Scene>& series) {
  Compositions compositions(series.size());
  Eigen::Index points = 0;
  double size = 0.0;
  double longest_time = 0.0;
  Forecast work;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Scene& scene = series[i];
    if (asked_to_end()) return compositions;
    if (scene.kind == SceneKind::kStretch) {
      throw bad_value("scene", "stretch", "contact or collision in a node; see the program impact");
    }
    const auto composition = compose_shared(scene);
    const Forecast expected = forecast_of(scene, *composition);
    work.steps += expected.steps;
    work.seconds += expected.seconds;
    size += expected_size(scene, *composition);
    longest_time += Run::kPatience * composition->expected_time;
    check_stamps(parameters.seconds_per_time_unit, scene.output.period, longest_time);
    points += composition->initial.position.rows();
    if (points <= kMostPointsKept || i == 0) compositions[i] = composition;
  }
  ROS_INFO("%s", fmt::format("{} run(s), at most about {:.3g} MB of messages, {}", series.size(),
                             size / 1e6, text(work))
                     .c_str());
  if (!parameters.bag.empty() && size > free_space(parameters.bag)) {
    throw InputError(fmt::format("bag: about {:.3g} GB are to be written to {}, {:.3g} GB are free",
                                 size / 1e9, parameters.bag, free_space(parameters.bag) / 1e9));
  }
  return compositions;
}

namespace {

bool is_published(const std::string& topic) {
  ros::master::V_TopicInfo topics;
  ros::master::getTopics(topics);
  return std::any_of(topics.begin(), topics.end(),
                     [&](const auto& info) { return info.name == topic; });
}

}  // namespace

SimulationNode::SimulationNode(const SimulationNodeParameters& parameters,
                               std::vector<Scene> series, Compositions compositions)
    : parameters_(parameters),
      series_(std::move(series)),
      compositions_(std::move(compositions)),
      readers_(node_, parameters.wait_for),
      wall_readers_(node_, parameters.wait_for_wall),
      scalar_readers_(node_, parameters.wait_for_scalars),
      streams_(most_bodies(series_), readers_, wall_readers_, scalar_readers_),
      pacing_(node_, parameters.acknowledged_by) {
  if (parameters.publish_clock) clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 0);
  if (parameters.max_rate > 0.0) rate_.emplace(parameters.max_rate);
  status_.runs = static_cast<std::uint32_t>(series_.size());
}

bool SimulationNode::run_series() {
  if (!parameters_.publish_clock && ros::Time::isSimTime() && !is_published("/clock")) {
    ROS_WARN(
        "/use_sim_time is true and nobody publishes /clock: simulated time will stand still; see "
        "publish_clock");
  }
  readers_.wait(parameters_.timeout);
  wall_readers_.wait(parameters_.timeout);
  scalar_readers_.wait(parameters_.timeout);
  pacing_.wait_for_links(parameters_.timeout);
  if (!asked_to_end()) streams_.open_bag(parameters_.bag);
  for (std::size_t i = 0; i < series_.size() && !asked_to_end(); ++i) {
    auto composition = std::exchange(compositions_[i], nullptr);
    simulate(series_[i], composition ? std::move(composition) : compose_shared(series_[i]));
    ++status_.run;
  }
  close_bag(!asked_to_end());
  if (asked_to_end() || !all_listeners_acknowledge()) ros::WallDuration(parameters_.linger).sleep();
  return !asked_to_end();
}

void SimulationNode::simulate(const Scene& scene,
                              const std::shared_ptr<const Composition>& composition) {
  ErrorControl control(scene, *composition);
  progress_.emplace(fmt::format("run {} of {}", status_.run + 1, status_.runs));
  std::string failure;
  try {
    control.find_resolution(composition, [this] {
      progress_->note_search();
      return asked_to_end();
    });
  } catch (const RunFailure& cause) {
    failure = cause.what();
  }
  take_answer(control);
  const Forecast expected = forecast_of(scene, *composition);
  status_.expected_steps = expected.steps;
  status_.expected_seconds = expected.seconds;
  Run run(scene, composition, control.resolution());
  start(scene, run);
  try {
    if (!failure.empty()) throw RunFailure(failure);
    const Restitution measured = publish_run(run, scene);
    if (run.finished() && !control.accepted()) control.accepts(run, measured);
    take_answer(control);
  } catch (const std::runtime_error& cause) {
    publish_status(run, lattice_impact::RunStatus::FAILED, cause.what());
    close_bag(false);
    throw;
  }
  publish_status(run, run.finished() ? lattice_impact::RunStatus::FINISHED
                                     : lattice_impact::RunStatus::INTERRUPTED);
  wait_for_readers(status_.states);
  run_start_ = status_.header.stamp + ros::Duration(1.0);
}

void SimulationNode::close_bag(bool complete) {
  const std::string name = streams_.close(complete);
  if (name.empty()) return;
  if (complete) {
    ROS_INFO("recorded in %s", name.c_str());
  } else {
    ROS_ERROR("the recording is not complete: kept as %s", name.c_str());
  }
}

Restitution SimulationNode::publish_run(Run& run, const Scene& scene) {
  ImpactAnalysis analysis(scene.gravity);
  publish_status(run, lattice_impact::RunStatus::RUNNING);
  publish_output(run, analysis);
  while (!run.finished() && !asked_to_end()) {
    run.advance(asked_to_end);
    publish_output(run, analysis);
    progress_->note_states(status_.states,
                           run.expected_time() / output_interval(scene, run.system().step_size()));
  }
  return analysis.restitution(run.finished() && !run.has_flag(Flag::kNotSeparated));
}

void SimulationNode::start(const Scene& scene, const Run& run) {
  checksum_ = 0;
  status_.sequence = 0;
  status_.states = 0;
  status_.scene = to_yaml(scene);
  status_.integrator = name_of(run.integrator());
  status_.terms = run.system().field().terms();

  status_.bodies = static_cast<std::uint32_t>(run.bodies().size());

  for (std::size_t body = 0; body < run.bodies().size(); ++body) send_lattice(body, run);
}

void SimulationNode::send_lattice(std::size_t body, const Run& run) {
  lattice_impact::Lattice message = to_message(run.bodies()[body].lattice);
  message.header.stamp = stamp(run);
  message.run = status_.run;
  message.name = name_of_body(body);
  message.point_mass = run.system().field().point_mass;
  if (body == 0) checksum_ += checksum_of(message);
  streams_.send(body, message);
}

void SimulationNode::publish_output(Run& run, ImpactAnalysis& analysis) {
  const ContactReports reports = run.take_contact_reports();
  analysis.add(reports.on_first);
  if (status_.states == 0 || run.finished()) run.show(analysis);
  if (streams_.scalars_heard()) send_scalars(run, reports.on_first);
  for (std::size_t body = 0; body < run.bodies().size(); ++body) {
    if (streams_.heard(body)) send(body, run, reports.on(body));
  }
  ++status_.states;
  if (status_.states % kStatusInterval == 0) {
    publish_status(run, lattice_impact::RunStatus::RUNNING);
  }
  if (parameters_.publish_clock) {
    rosgraph_msgs::Clock clock;
    clock.clock = stamp(run);
    clock_.publish(clock);
  }
  keep_pace();
}

void SimulationNode::send(std::size_t body, const Run& run, const ContactReport& report) {
  to_message(report, forces_);
  forces_.header.stamp = stamp(run);
  forces_.run = status_.run;
  forces_.sequence = status_.states;
  const RawMessage<lattice_impact::ContactForces> forces(forces_);
  const RawMessage<lattice_impact::ParticleStates> states(StatesOfBody{
      forces_.header, forces_.run, forces_.sequence, run.state(), run.system().field().body(body)});
  if (body == 0) checksum_ += checksum_of(states) + checksum_of(forces);
  streams_.send(body, forces_.header.stamp, states);
  streams_.send(body, forces_.header.stamp, forces);
}

void SimulationNode::send_scalars(const Run& run, const ContactReport& report) {
  const State disk = run.disk_state();
  lattice_impact::Scalars message = to_message(body_motion(disk.position, disk.velocity), report,
                                               run.system().ledger(), run.energy_error());
  message.header.stamp = stamp(run);
  message.run = status_.run;
  message.sequence = status_.states;
  streams_.send(message);
}

void SimulationNode::publish_status(const Run& run, std::uint8_t phase, const std::string& error) {
  const bool ended = phase == lattice_impact::RunStatus::FINISHED;
  status_.header.stamp = stamp(run);
  status_.phase = phase;
  status_.progress = ended ? 1.0 : std::min(1.0, run.state().time / run.expected_time());
  status_.step_size = run.system().step_size();
  status_.flags = run.flags();
  status_.error = error;
  status_.energy = to_message(run.system().ledger(), run.energy_error());
  status_.checksum = checksum_with(checksum_, status_);
  streams_.send(status_);
  ++status_.sequence;
}

void SimulationNode::take_answer(const ErrorControl& control) {
  status_.estimated_error = control.estimated_error();
  status_.answer = numbers_to_message(control.answer().value);
  status_.answer_error = numbers_to_message(control.answer().error);
  status_.restitution_of_run_error = control.answer().error_of_run;
}

void SimulationNode::keep_pace() {
  ros::spinOnce();
  readers_.check();
  wall_readers_.check();
  scalar_readers_.check();
  const std::int64_t due = static_cast<std::int64_t>(status_.states) - Pacing::kWindow;
  if (due >= 0) wait_for_readers(due);
  if (rate_) rate_->sleep();
}

void SimulationNode::wait_for_readers(std::int64_t sequence) {
  pacing_.wait(status_.run, sequence, parameters_.timeout, [this](const std::string& name) {
    return readers_.hears(name) || wall_readers_.hears(name);
  });
}

/// By everybody who listens, when the last run has ended.
bool SimulationNode::all_listeners_acknowledge() const {
  if (parameters_.acknowledged_by.empty()) return false;
  const auto readers = {&readers_, &wall_readers_, &scalar_readers_};
  return std::all_of(readers.begin(), readers.end(), [this](const Readers* group) {
    const std::set<std::string> names = group->subscribers();
    return std::all_of(names.begin(), names.end(),
                       [this](const std::string& name) { return pacing_.heeds(name); });
  });
}

ros::Time SimulationNode::stamp(const Run& run) const {
  return run_start_ + ros::Duration(run.state().time * parameters_.seconds_per_time_unit);
}

}  // namespace impact
