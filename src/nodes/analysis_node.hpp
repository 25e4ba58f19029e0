#pragma once

#include <ros/ros.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "nodes/message_source.hpp"
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
  template <class Message>
  void publish(const ros::Publisher& publisher, const Message& message);
  void publish(const lattice_impact::Restitution& restitution);
  void publish(const lattice_impact::Strain& strain);
  void publish(const lattice_impact::LawFit& law);
  void acknowledge(std::uint32_t run, std::uint32_t sequence);
  bool is_alone() const;
  void wait_for_publishers_to_go();
  void linger();
  bool nothing_more_comes() const;

  AnalysisNodeParameters parameters_;
  ros::NodeHandle node_;
  Readers readers_;
  ros::Publisher strain_;
  ros::Publisher restitution_;
  ros::Publisher law_fit_;
  ros::Publisher acknowledged_;
  std::map<std::string, std::uint64_t> results_;  ///< published so far, by topic
  std::vector<ros::Subscriber> subscribers_;
  SeriesFits fits_;
  SeriesAnalysis analysis_;
  MessageSource source_;
  bool complete_ = true;
};

}  // namespace impact
