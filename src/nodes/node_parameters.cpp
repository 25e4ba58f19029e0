#include "nodes/node_parameters.hpp"

#include <ros/names.h>

#include <algorithm>
#include <utility>

namespace impact {
namespace {

constexpr Interval kWaitingTime{0.0, 86400.0, false};

/// A list of names of nodes.
template <class T, class Member>
Parameter<T> node_names(std::string key, std::string meaning, Member member) {
  Parameter<T> parameter = texts<T>(std::move(key), std::move(meaning), member);
  parameter.allowed = "list of names of nodes";
  parameter.read = [read = parameter.read, member](T& target, const YAML::Node& node) {
    if (!read(target, node)) return false;
    const auto is_name = [](const std::string& name) {
      std::string error;
      return !name.empty() && ros::names::validate(name, error);
    };
    return std::all_of(member(target).begin(), member(target).end(), is_name);
  };
  return parameter;
}

template <class T>
Parameter<T> wait_for() {
  return node_names<T>(
      "wait_for", "those that must have subscribed to every other data topic before the start",
      [](auto& p) -> auto& { return p.wait_for; });
}

template <class T>
Parameter<T> acknowledged_by() {
  return node_names<T>(
      "acknowledged_by",
      "those whose acknowledgements pace the run: it stays at most 100 states ahead of each",
      [](auto& p) -> auto& { return p.acknowledged_by; });
}

template <class T>
Parameter<T> timeout(std::string meaning) {
  return real<T>(
      "timeout", "s", kWaitingTime, std::move(meaning), [](auto& p) -> auto& { return p.timeout; });
}

template <class T>
Parameter<T> linger(const std::string& unless = {}) {
  return real<T>(
      "linger", "s", {0.0, 3600.0}, "how long to stay after the last message" + unless,
      [](auto& p) -> auto& { return p.linger; });
}

template <class T>
Parameter<T> patience(std::string meaning) {
  return real<T>(
      "patience", "s", kWaitingTime, std::move(meaning),
      [](auto& p) -> auto& { return p.patience; });
}

}  // namespace

const std::vector<Parameter<SimulationNodeParameters>>& simulation_node_parameters() {
  using P = SimulationNodeParameters;
  static const std::vector<Parameter<P>> table{
      text<P>(
          "scene_yaml", "text of a scene file; keys that are parameters too replace its own",
          [](auto& p) -> auto& { return p.scene_yaml; }),
      texts<P>(
          "assignments", "key=value …, each replaces that key, as with impact",
          [](auto& p) -> auto& { return p.assignments; }),
      text<P>(
          "bag", "file to write all messages to, from inside the node; empty: none",
          [](auto& p) -> auto& { return p.bag; }),
      wait_for<P>(),
      node_names<P>(
          "wait_for_wall",
          "those that must have subscribed to every topic of an elastic wall before the start",
          [](auto& p) -> auto& { return p.wait_for_wall; }),
      node_names<P>(
          "wait_for_scalars", "those that must have subscribed to scalars before the start",
          [](auto& p) -> auto& { return p.wait_for_scalars; }),
      acknowledged_by<P>(),
      timeout<P>("how long to wait for a subscriber or an acknowledgement before giving up"),
      real<P>(
          "max_rate", "states/s", {0.0, 1e6}, "most states published a second; 0: no limit",
          [](auto& p) -> auto& { return p.max_rate; }),
      linger<P>(", unless all who listen are in acknowledged_by"),
      flag<P>(
          "publish_clock", "publish the simulated time on /clock",
          [](auto& p) -> auto& { return p.publish_clock; }),
      real<P>(
          "seconds_per_time_unit", "s c/R", {1e-6, 1e6, true},
          "simulated seconds in the stamps for each R/c",
          [](auto& p) -> auto& { return p.seconds_per_time_unit; })};
  return table;
}

const std::vector<Parameter<AnalysisNodeParameters>>& analysis_node_parameters() {
  using P = AnalysisNodeParameters;
  static const std::vector<Parameter<P>> table{
      wait_for<P>(),
      timeout<P>("how long to wait for a subscriber and, with exit_when_done, for any message"),
      patience<P>("silence after the end of a run at which missing messages count as lost"),
      linger<P>("; with wait_for at most until nobody listens"),
      flag<P>(
          "exit_when_done",
          "end when the last run of the series is analysed, or its publishers have gone",
          [](auto& p) -> auto& { return p.exit_when_done; }),
      real_or_auto<P>(
          "young_modulus", "M c²/R²", {0.0, ElasticParameters::kHighestModulus, false},
          "E of the disk for law_fit; auto: measured on the recipe in use, none for a disk.file",
          [](auto& p) -> auto& { return p.elastic.young_modulus; }),
      real_or_auto<P>(
          "poisson_ratio", "-",
          {-ElasticParameters::kHighestRatio, ElasticParameters::kHighestRatio},
          "ν of the disk for law_fit; auto: as for young_modulus",
          [](auto& p) -> auto& { return p.elastic.poisson_ratio; })};
  return table;
}

const std::vector<Parameter<RecorderNodeParameters>>& recorder_node_parameters() {
  using P = RecorderNodeParameters;
  static const std::vector<Parameter<P>> table{
      text<P>(
          "bag", "file to record to", [](auto& p) -> auto& { return p.bag; }),
      node_names<P>(
          "results_of",
          "those whose results are recorded too: the recording of a run waits for them",
          [](auto& p) -> auto& { return p.results_of; }),
      timeout<P>("how long to wait for the first message, and at the end for the simulation"),
      patience<P>("silence at which a simulation that has gone is taken to have broken off")};
  return table;
}

const std::vector<Parameter<ReplayNodeParameters>>& replay_node_parameters() {
  using P = ReplayNodeParameters;
  static const std::vector<Parameter<P>> table{
      text<P>(
          "bag", "file to replay", [](auto& p) -> auto& { return p.bag; }),
      text<P>(
          "ns", "namespace of the simulation in the bag",
          [](auto& p) -> auto& { return p.recorded_in; }),
      real<P>(
          "rate", "-", {0.0, 1e9, false}, "factor on the speed of the recording",
          [](auto& p) -> auto& { return p.rate; }),
      wait_for<P>(),
      acknowledged_by<P>(),
      timeout<P>("how long to wait for a subscriber and, at the end, for an acknowledgement"),
      patience<P>("silence at which the rest of a run is sent without acknowledgements"),
      linger<P>()};
  return table;
}

}  // namespace impact
