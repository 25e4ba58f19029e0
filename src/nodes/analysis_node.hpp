#pragma once

#include <ros/ros.h>

#include <string>
#include <vector>

#include "nodes/node_parameters.hpp"
#include "nodes/readers.hpp"
#include "nodes/series_analysis.hpp"
#include "nodes/series_fits.hpp"

namespace impact {

/// Analyses a series while it is simulated or replayed, fits the paper's laws to it, and publishes
/// the results.
class AnalysisNode {
 public:
  explicit AnalysisNode(const AnalysisNodeParameters& parameters);

  /// Takes in messages until interrupted or, if asked for, until the series is done or its
  /// publishers have gone. False when messages were missing.
  /// @throw std::runtime_error when a reader of the results is missing, or nothing came at all.
  bool run();

 private:
  template <class Message>
  void subscribe(const std::string& topic);
  void publish(const lattice_impact::Restitution& restitution);
  void publish(const lattice_impact::Strain& strain);
  void publish(const lattice_impact::LawFit& law);
  void acknowledge(std::uint32_t run, std::uint32_t sequence);
  double silence() const;
  double patience_for_publishers() const;

  AnalysisNodeParameters parameters_;
  ros::NodeHandle node_;
  Readers readers_;
  ros::Publisher strain_;
  ros::Publisher restitution_;
  ros::Publisher law_fit_;
  ros::Publisher acknowledged_;
  std::vector<ros::Subscriber> subscribers_;
  SeriesFits fits_;
  SeriesAnalysis analysis_;
  ros::WallTime last_message_;
  bool any_message_ = false;
  bool complete_ = true;
};

}  // namespace impact
