#pragma once

#include <lattice_impact/LawFit.h>
#include <lattice_impact/Restitution.h>
#include <lattice_impact/RunStatus.h>
#include <lattice_impact/Strain.h>
#include <rosbag/message_instance.h>

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "nodes/inventory.hpp"
#include "nodes/series_analysis.hpp"
#include "nodes/series_fits.hpp"
#include "output/result.hpp"
#include "scene/disk_elasticity.hpp"

namespace impact {

/// The topics of one namespace of a bag: what was recorded, what was published, and the results.
class BagPipeline {
 public:
  /// Is told what is missing or wrong, a line each, which begins with the namespace.
  using Problem = std::function<void(const std::string&)>;

  BagPipeline(std::string name_space, const ElasticParameters& elastic, Problem problem);

  void add(const rosbag::MessageInstance& message);
  /// No more messages will come.
  void close();

  bool has_runs() const { return !recorded_.empty() || !recorded_results_.empty(); }
  /// No problem was told.
  bool complete() const { return complete_; }

  /// The messages of each topic, the results of the runs, and the last fit of each group of runs.
  YAML::Node document() const;
  /// The results, the fits and the count of messages, as text.
  std::string text() const;

 private:
  void report(const std::string& problem);

  bool is_of_wall(const std::string& topic) const;
  std::string prefix() const { return (name_space_ == "/" ? "" : name_space_) + "/"; }
  std::string full_name(const std::string& topic) const { return prefix() + topic; }
  std::string short_name(const rosbag::MessageInstance& message) const {
    return message.getTopic().substr(prefix().size());
  }

  /// On the topic of its type: on any other one it is as good as missing.
  template <class Message>
  bool is_a(const rosbag::MessageInstance& message) const;
  /// Null for a message of another type.
  template <class Message>
  boost::shared_ptr<Message> counted(const rosbag::MessageInstance& message);
  /// Of what is counted only.
  template <class Message>
  bool count(const rosbag::MessageInstance& message);
  template <class Message>
  bool take(const rosbag::MessageInstance& message);
  bool take_status(const rosbag::MessageInstance& message);
  template <class Message>
  bool result(const rosbag::MessageInstance& message);

  void add_result(const lattice_impact::Strain& strain);
  void add_result(const lattice_impact::Restitution& restitution);
  void add_result(const lattice_impact::LawFit& law);

  Scene scene_of(const Result& result) const;
  Result completed(Result result) const;
  YAML::Node topics() const;
  std::string block(const Result& result) const;
  std::string table_of_runs() const;

  SeriesFits fits_;
  SeriesAnalysis analysis_;
  std::string name_space_;
  Problem problem_;
  Inventory inventory_;
  // Messages by topic below the namespace.
  std::map<std::string, std::uint64_t> recorded_;
  std::map<std::string, std::uint64_t> recorded_results_;
  std::map<std::string, std::uint64_t> computed_results_;
  std::map<std::uint32_t, lattice_impact::RunStatus> statuses_;  ///< the last of each run
  std::vector<Result> results_;
  std::map<std::string, lattice_impact::LawFit> law_fits_;  ///< by the keys that the runs share
  bool complete_ = true;
};

/// All messages of a bag, by namespace; the pipelines are closed.
/// @throw InputError when it is no bag or was not closed, std::runtime_error when it is damaged
/// where rosbag notices.
std::map<std::string, BagPipeline> read_bag(const std::string& file,
                                            const ElasticParameters& elastic,
                                            const BagPipeline::Problem& problem);

}  // namespace impact
