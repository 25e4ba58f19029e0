#pragma once

#include <string>
#include <vector>

#include "scene/disk_elasticity.hpp"
#include "scene/parameter_table.hpp"

namespace impact {

/// What the simulation node has besides the keys of its scene.
struct SimulationNodeParameters {
  std::string scene_yaml;                     ///< empty: none
  std::vector<std::string> assignments;       ///< key=value
  std::string bag;                            ///< empty: none
  std::vector<std::string> wait_for;          ///< names of nodes
  std::vector<std::string> wait_for_wall;     ///< names of nodes
  std::vector<std::string> wait_for_scalars;  ///< names of nodes
  std::vector<std::string> acknowledged_by;   ///< names of nodes
  double timeout = 30.0;                      ///< s
  double max_rate = 0.0;                      ///< states/s; 0: none
  double linger = 0.5;                        ///< s
  bool publish_clock = false;
  double seconds_per_time_unit = 1.0;
};

struct AnalysisNodeParameters {
  std::vector<std::string> wait_for;  ///< names of nodes
  double timeout = 30.0;              ///< s
  double patience = 5.0;              ///< s
  double linger = 0.5;                ///< s
  bool exit_when_done = false;
  ElasticParameters elastic;
};

struct RecorderNodeParameters {
  std::string bag;
  std::vector<std::string> results_of;  ///< names of nodes
  double timeout = 30.0;                ///< s
  double patience = 5.0;                ///< s
};

struct ReplayNodeParameters {
  std::string bag;
  std::string recorded_in = "lattice_impact";  ///< namespace
  double rate = 1.0;
  std::vector<std::string> wait_for;         ///< names of nodes
  std::vector<std::string> acknowledged_by;  ///< names of nodes
  double timeout = 30.0;                     ///< s
  double patience = 5.0;                     ///< s
  double linger = 0.5;                       ///< s
};

const std::vector<Parameter<SimulationNodeParameters>>& simulation_node_parameters();
const std::vector<Parameter<AnalysisNodeParameters>>& analysis_node_parameters();
const std::vector<Parameter<RecorderNodeParameters>>& recorder_node_parameters();
const std::vector<Parameter<ReplayNodeParameters>>& replay_node_parameters();

}  // namespace impact
