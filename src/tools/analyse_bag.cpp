// The analysis node's numbers, straight from a bag, and whether the bag holds all that was
// published.

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "nodes/series_analysis.hpp"
#include "nodes/series_fits.hpp"
#include "scene/parameter_table.hpp"
#include "tools/law_fit_yaml.hpp"
#include "tools/program.hpp"
#include "tools/restitution_yaml.hpp"

namespace impact {
namespace {

/// The topics of one namespace: what was recorded, what was published, and the results.
class Pipeline {
 public:
  Pipeline(std::string name_space, const ElasticParameters& elastic)
      : fits_(elastic, [this](const lattice_impact::LawFit& law) { add_result(law); }),
        analysis_({[this](const lattice_impact::Strain& strain) { add_result(strain); },
                   [this](const lattice_impact::Restitution& result) { add_result(result); },
                   [this](const ClosedRun& run) { fits_.add(run); },
                   [](std::uint32_t, std::uint32_t) {},
                   [this](const std::string& problem) { report(problem); }}),
        name_space_(std::move(name_space)) {}

  void add(const rosbag::MessageInstance& message) {
    if (is_of_wall(message.getTopic())) {
      count<lattice_impact::Lattice>(message) || count<lattice_impact::ParticleStates>(message) ||
          count<lattice_impact::ContactForces>(message);
      return;
    }
    take<lattice_impact::Lattice>(message) || take<lattice_impact::ParticleStates>(message) ||
        take<lattice_impact::ContactForces>(message) || take_status(message) ||
        count<lattice_impact::Strain>(message) || count<lattice_impact::Restitution>(message) ||
        count<lattice_impact::LawFit>(message);
  }

  void close() {
    analysis_.close();
    for (const auto& status : last_status_) {
      count_published("", status.second.states);
      const auto& terms = status.second.terms;
      if (std::find(terms.begin(), terms.end(), "elastic wall") != terms.end()) {
        count_published(kWall, status.second.states);
      }
      published_[type<lattice_impact::RunStatus>()] += status.second.sequence + 1;
      if (status.second.phase == lattice_impact::RunStatus::INTERRUPTED) {
        report(fmt::format("run {}: interrupted", status.first));
      }
      if (status.second.phase == lattice_impact::RunStatus::FAILED) {
        report(fmt::format("run {}: {}", status.first, status.second.error));
      }
    }
    for (const auto& topic : topics_) {
      complete_ = complete_ && topic.second.recorded == published_[topic.second.type];
    }
  }

  bool has_runs() const { return !topics_.empty(); }
  bool complete() const { return complete_; }

  YAML::Node topics() {
    YAML::Node node;
    for (const auto& topic : topics_) {
      YAML::Node counts;
      counts["published"] = published_[topic.second.type];
      counts["recorded"] = topic.second.recorded;
      counts.SetStyle(YAML::EmitterStyle::Flow);
      node[topic.first] = counts;
    }
    return node;
  }

  const std::vector<YAML::Node>& results() const { return results_; }

  /// The last of each group of runs.
  const std::map<std::string, lattice_impact::LawFit>& law_fits() const { return law_fits_; }

 private:
  void report(const std::string& problem) {
    complete_ = false;
    fmt::print(stderr, "analyse_bag: {}: {}\n", name_space_, problem);
  }

  /// The topics of an elastic wall are counted only.
  static constexpr const char* kWall = "wall/";
  bool is_of_wall(const std::string& topic) const {
    const std::string prefix = (name_space_ == "/" ? "" : name_space_) + "/" + kWall;
    return topic.compare(0, prefix.size(), prefix) == 0;
  }

  void count_published(const std::string& body, std::uint32_t states) {
    published_[body + type<lattice_impact::Lattice>()] += 1;
    published_[body + type<lattice_impact::ParticleStates>()] += states;
    published_[body + type<lattice_impact::ContactForces>()] += states;
  }

  struct Topic {
    std::string type;  ///< of its messages, after "wall/" where it is the wall's
    std::uint64_t recorded = 0;
  };

  template <class Message>
  static std::string type() {
    return ros::message_traits::DataType<Message>::value();
  }

  template <class Message>
  bool count(const rosbag::MessageInstance& message) {
    if (!message.isType<Message>()) return false;
    Topic& topic = topics_[message.getTopic()];
    topic.type = (is_of_wall(message.getTopic()) ? kWall : "") + type<Message>();
    ++topic.recorded;
    return true;
  }

  template <class Message>
  bool take(const rosbag::MessageInstance& message) {
    if (!count<Message>(message)) return false;
    analysis_.add(*message.instantiate<Message>());
    return true;
  }

  bool take_status(const rosbag::MessageInstance& message) {
    if (!message.isType<lattice_impact::RunStatus>()) return false;
    const auto status = message.instantiate<lattice_impact::RunStatus>();
    last_status_[status->run] = *status;
    return take<lattice_impact::RunStatus>(message);
  }

  void add_result(const lattice_impact::Strain& strain) {
    ++published_[type<lattice_impact::Strain>()];
    if (strain.at_rest == 0) return;
    YAML::Node node;
    node["run"] = strain.run;
    node["strain"] = exact(strain.strain);
    node["strain_from_radius"] = exact(strain.strain_from_radius);
    node["rotation"] = exact(strain.rotation);
    node["wall_force"] = exact(strain.force);
    results_.push_back(node);
  }

  void add_result(const lattice_impact::Restitution& restitution) {
    ++published_[type<lattice_impact::Restitution>()];
    if (restitution.ended == 0) return;
    YAML::Node node;
    node["run"] = restitution.run;
    node["complete"] = restitution.complete != 0;
    node["velocity"] = exact(-restitution.velocity_before);
    add_impact(restitution, "", node);
    add_impact(restitution.error, "_error", node);
    node["restitution_of_run"] = exact(restitution.restitution_of_run);
    node["restitution_of_run_error"] = exact(restitution.restitution_of_run_error);
    node["flags"] = flag_list(restitution.flags);
    results_.push_back(node);
  }

  void add_result(const lattice_impact::LawFit& law) {
    ++published_[type<lattice_impact::LawFit>()];
    law_fits_[law.scene] = law;
  }

  SeriesFits fits_;
  SeriesAnalysis analysis_;
  std::string name_space_;
  std::map<std::string, Topic> topics_;                             ///< recorded, by name
  std::map<std::string, std::uint64_t> published_;                  ///< by Topic::type
  std::map<std::uint32_t, lattice_impact::RunStatus> last_status_;  ///< by run
  std::vector<YAML::Node> results_;
  std::map<std::string, lattice_impact::LawFit> law_fits_;  ///< by the keys that the runs share
  bool complete_ = true;
};

std::string name_space_of(const std::string& topic) {
  const std::size_t slash = topic.rfind('/');
  return slash == 0 || slash == std::string::npos ? "/" : topic.substr(0, slash);
}

/// The namespaces in which a simulation publishes.
std::set<std::string> simulations(rosbag::View& view) {
  std::set<std::string> name_spaces;
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    if (connection->datatype == ros::message_traits::DataType<lattice_impact::RunStatus>::value()) {
      name_spaces.insert(name_space_of(connection->topic));
    }
  }
  return name_spaces;
}

/// The namespace of the simulation that published this topic: that of the topic itself, or the one
/// above it for the topics of an elastic wall.
std::string pipeline_of(const std::string& topic, const std::set<std::string>& simulations) {
  const std::string name_space = name_space_of(topic);
  const std::string above = name_space_of(name_space);
  return simulations.count(name_space) == 0 && simulations.count(above) > 0 ? above : name_space;
}

void analyse(const std::string& file, const ElasticParameters& elastic) {
  rosbag::Bag bag;
  try {
    bag.open(file, rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw InputError(fmt::format("{} was not closed: mend it with `rosbag reindex`", file));
  } catch (const rosbag::BagException& error) {
    throw InputError(fmt::format("{} cannot be read: {}", file, error.what()));
  }

  std::map<std::string, Pipeline> pipelines;
  rosbag::View view(bag);
  const std::set<std::string> name_spaces = simulations(view);
  for (const rosbag::MessageInstance& message : view) {
    const std::string name_space = pipeline_of(message.getTopic(), name_spaces);
    pipelines.try_emplace(name_space, name_space, elastic).first->second.add(message);
  }

  bool complete = true;
  YAML::Node document;
  for (auto& pipeline : pipelines) {
    pipeline.second.close();
    if (!pipeline.second.has_runs()) continue;
    YAML::Node node;
    node["topics"] = pipeline.second.topics();
    for (const YAML::Node& result : pipeline.second.results()) node["runs"].push_back(result);
    for (const auto& law : pipeline.second.law_fits()) {
      if (law.second.x.size() > 1) node["law_fits"].push_back(to_yaml(law.second));
    }
    document[pipeline.first] = node;
    complete = complete && pipeline.second.complete();
  }
  if (document.IsNull()) throw InputError(fmt::format("{} holds no run", file));
  fmt::print("{}\n", YAML::Dump(document));
  if (!complete) throw std::runtime_error(fmt::format("{} is not complete", file));
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  CLI::App app("Analyses a recorded series and counts its messages; result as YAML.",
               "analyse_bag");
  std::string file;
  app.add_option("bag", file, "the bag")->required();
  impact::ElasticParameters elastic;
  constexpr double kHighestModulus = impact::ElasticParameters::kHighestModulus;
  constexpr double kHighestRatio = impact::ElasticParameters::kHighestRatio;
  app.add_option("--young-modulus", elastic.young_modulus, "E of the disk, M c^2/R^2")
      ->check(CLI::Range(std::numeric_limits<double>::min(), kHighestModulus));
  app.add_option("--poisson-ratio", elastic.poisson_ratio, "of the disk")
      ->check(CLI::Range(-kHighestRatio, kHighestRatio));
  return impact::run_tool(app, argc, argv, [&] { impact::analyse(file, elastic); });
}
