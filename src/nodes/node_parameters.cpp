#include "nodes/node_parameters.hpp"

namespace impact {
namespace {

constexpr Interval kWaitingTime{0.0, 86400.0, false};

template <class T>
Parameter<T> wait_for() {
  return texts<T>(
      "wait_for",
      "names of the nodes that must have subscribed to every data topic before "
      "the start",
      [](T & p) -> auto& { return p.wait_for; });
}

template <class T>
Parameter<T> timeout(std::string meaning) {
  return real<T>(
      "timeout", "s", kWaitingTime, std::move(meaning), [](T & p) -> auto& { return p.timeout; });
}

template <class T>
Parameter<T> linger() {
  return real<T>(
      "linger", "s", {0.0, 3600.0}, "how long to stay after the last message",
      [](T & p) -> auto& { return p.linger; });
}

}  // namespace

const std::vector<Parameter<SimulationNodeParameters>>& simulation_node_parameters() {
  using P = SimulationNodeParameters;
  static const std::vector<Parameter<P>> table{
      text<P>(
          "bag", "file to write all messages to, from inside the node; empty: none",
          [](P & p) -> auto& { return p.bag; }),
      wait_for<P>(),
      texts<P>(
          "acknowledged_by",
          "names of the nodes whose acknowledgements pace the run: it stays at most 100 "
          "states ahead of each",
          [](P & p) -> auto& { return p.acknowledged_by; }),
      timeout<P>("how long to wait for a subscriber or an acknowledgement before giving up"),
      real<P>(
          "max_rate", "states/s", {0.0, 1e6}, "most states published a second; 0: no limit",
          [](P & p) -> auto& { return p.max_rate; }),
      linger<P>(),
      flag<P>(
          "publish_clock", "publish the simulated time on /clock",
          [](P & p) -> auto& { return p.publish_clock; }),
      real<P>(
          "seconds_per_time_unit", "s c/R", {1e-6, 1e6, true},
          "simulated seconds in the stamps for each R/c",
          [](P & p) -> auto& { return p.seconds_per_time_unit; })};
  return table;
}

const std::vector<Parameter<AnalysisNodeParameters>>& analysis_node_parameters() {
  using P = AnalysisNodeParameters;
  static const std::vector<Parameter<P>> table{
      wait_for<P>(),
      timeout<P>("how long to wait for a subscriber and, with exit_when_done, for any message"),
      real<P>(
          "patience", "s", kWaitingTime,
          "silence after the end of a run at which missing messages count as lost",
          [](P & p) -> auto& { return p.patience; }),
      linger<P>(),
      flag<P>(
          "exit_when_done", "end when the last run of the series is analysed",
          [](P & p) -> auto& { return p.exit_when_done; })};
  return table;
}

}  // namespace impact
