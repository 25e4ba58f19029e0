// The analysis node's numbers, straight from a bag, and whether the bag holds all that was
// published.

#include <console_bridge/console.h>
#include <lattice_impact/Scalars.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "nodes/inventory.hpp"
#include "nodes/law_fit_yaml.hpp"
#include "nodes/series_analysis.hpp"
#include "nodes/series_fits.hpp"
#include "output/program.hpp"
#include "output/restitution_yaml.hpp"
#include "output/result_text.hpp"
#include "output/text_table.hpp"
#include "scene/keys.hpp"
#include "scene/scene_parameters.hpp"

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
        result<lattice_impact::Strain>(message) || result<lattice_impact::Restitution>(message) ||
        result<lattice_impact::LawFit>(message) || count<lattice_impact::Scalars>(message);
  }

  void close() {
    analysis_.close();
    for (const std::string& problem : inventory_.problems()) report(problem);
    for (const auto& [topic, recorded] : recorded_results_) {
      const std::uint64_t found = computed_results_[topic];
      if (recorded != found) {
        report(fmt::format("{}: {} messages, {} from the data", topic, recorded, found));
      }
    }
  }

  bool has_runs() const { return !recorded_.empty() || !recorded_results_.empty(); }
  bool complete() const { return complete_; }

  YAML::Node topics() {
    YAML::Node node;
    for (const auto& [topic, recorded] : recorded_) {
      node[full_name(topic)] = counts(inventory_.published(topic), recorded);
    }
    for (const auto& [topic, recorded] : recorded_results_) {
      node[full_name(topic)] = counts(computed_results_.at(topic), recorded);
    }
    return node;
  }

  const std::vector<YAML::Node>& results() const { return results_; }

  /// The results, the fits and the count of messages, as text.
  std::string text() const {
    std::string text = results_.size() > 1 ? table_of_runs() : std::string();
    if (results_.size() == 1) text = block(results_.front());
    for (const auto& law : law_fits_) {
      if (law.second.x.size() > 1) text += fmt::format("  fit: {}\n", outcome(law.second));
    }
    std::uint64_t recorded = 0;
    for (const auto& topic : recorded_) recorded += topic.second;
    for (const auto& topic : recorded_results_) recorded += topic.second;
    return text + fmt::format("  {} messages on {} topics{}\n", recorded,
                              recorded_.size() + recorded_results_.size(),
                              complete_ ? ", all that were published" : "");
  }

  /// The last of each group of runs.
  const std::map<std::string, lattice_impact::LawFit>& law_fits() const { return law_fits_; }

 private:
  void report(const std::string& problem) {
    complete_ = false;
    fmt::print(stderr, "analyse_bag: {}: {}\n", name_space_, problem);
  }

  bool is_of_wall(const std::string& topic) const {
    const std::string of_wall = full_name("wall/");
    return topic.compare(0, of_wall.size(), of_wall) == 0;
  }
  std::string prefix() const { return (name_space_ == "/" ? "" : name_space_) + "/"; }
  std::string full_name(const std::string& topic) const { return prefix() + topic; }
  std::string short_name(const rosbag::MessageInstance& message) const {
    return message.getTopic().substr(prefix().size());
  }

  static YAML::Node counts(std::uint64_t published, std::uint64_t recorded) {
    YAML::Node node;
    node["published"] = published;
    node["recorded"] = recorded;
    node.SetStyle(YAML::EmitterStyle::Flow);
    return node;
  }

  /// Null for a message of another type.
  template <class Message>
  boost::shared_ptr<Message> counted(const rosbag::MessageInstance& message) {
    if (!message.isType<Message>()) return nullptr;
    ++recorded_[short_name(message)];
    return message.instantiate<Message>();
  }

  /// Of what is counted only.
  template <class Message>
  bool count(const rosbag::MessageInstance& message) {
    const auto content = counted<Message>(message);
    if (content) inventory_.add(short_name(message), content->run);
    return content != nullptr;
  }

  template <class Message>
  bool take(const rosbag::MessageInstance& message) {
    const auto content = counted<Message>(message);
    if (!content) return false;
    inventory_.add(short_name(message), content->run);
    analysis_.add(*content);
    return true;
  }

  bool take_status(const rosbag::MessageInstance& message) {
    const auto content = counted<lattice_impact::RunStatus>(message);
    if (!content) return false;
    inventory_.add(*content);
    analysis_.add(*content);
    statuses_[content->run] = *content;
    return true;
  }

  /// What is wrong with the scene of a damaged bag was reported.
  Scene scene_of(const YAML::Node& result) const {
    const auto status = statuses_.find(result["run"].as<std::uint32_t>());
    try {
      if (status != statuses_.end()) return parse_scene(parse_keys(status->second.scene, "scene"));
    } catch (const InputError&) {
    }
    Scene scene;
    scene.kind = result["strain"] ? SceneKind::kContact : SceneKind::kCollision;
    return scene;
  }

  /// With what the status of the run adds.
  YAML::Node completed(const YAML::Node& result) const {
    YAML::Node completed = YAML::Clone(result);
    const auto status = statuses_.find(result["run"].as<std::uint32_t>());
    if (status == statuses_.end()) return completed;
    completed["estimated_error"] = exact(status->second.estimated_error);
    if (!result["flags"]) completed["flags"] = flag_list(status->second.flags);
    return completed;
  }

  std::string block(const YAML::Node& result) const {
    const Scene scene = scene_of(result);
    return title(scene) + "\n" + result_block(completed(result), scene);
  }

  std::string table_of_runs() const {
    std::string text = fmt::format("{} runs\n", results_.size());
    std::vector<YAML::Node> results;
    for (const YAML::Node& result : results_) results.push_back(completed(result));
    return text + result_table(results, scene_of(results_.front()).kind);
  }

  template <class Message>
  bool result(const rosbag::MessageInstance& message) {
    if (!message.isType<Message>()) return false;
    ++recorded_results_[short_name(message)];
    computed_results_.try_emplace(short_name(message), 0);
    return true;
  }

  void add_result(const lattice_impact::Strain& strain) {
    ++computed_results_["strain"];
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
    ++computed_results_["restitution"];
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
    ++computed_results_["law_fit"];
    law_fits_[law.scene] = law;
  }

  SeriesFits fits_;
  SeriesAnalysis analysis_;
  std::string name_space_;
  Inventory inventory_;
  // Messages by topic below the namespace.
  std::map<std::string, std::uint64_t> recorded_;
  std::map<std::string, std::uint64_t> recorded_results_;
  std::map<std::string, std::uint64_t> computed_results_;
  std::map<std::uint32_t, lattice_impact::RunStatus> statuses_;  ///< the last of each run
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

/// All its messages, by namespace.
std::map<std::string, Pipeline> read(const std::string& file, const ElasticParameters& elastic) {
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
  return pipelines;
}

/// rosbag reads what the bytes say, and throws as many things as can be wrong with them.
std::map<std::string, Pipeline> read_undamaged(const std::string& file,
                                               const ElasticParameters& elastic) {
  try {
    return read(file, elastic);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{} is damaged: {}", file, error.what()));
  }
}

YAML::Node document_of(Pipeline& pipeline) {
  YAML::Node node;
  node["topics"] = pipeline.topics();
  for (const YAML::Node& result : pipeline.results()) node["runs"].push_back(result);
  for (const auto& law : pipeline.law_fits()) {
    if (law.second.x.size() > 1) node["law_fits"].push_back(to_yaml(law.second));
  }
  return node;
}

void analyse(const std::string& file, const ElasticParameters& elastic, Format format) {
  std::map<std::string, Pipeline> pipelines = read_undamaged(file, elastic);
  bool complete = true;
  YAML::Node document;
  std::string text;
  for (auto& [name_space, pipeline] : pipelines) {
    pipeline.close();
    if (!pipeline.has_runs()) continue;
    document[name_space] = document_of(pipeline);
    text += fmt::format("{}: {}", name_space, pipeline.text());
    complete = complete && pipeline.complete();
  }
  if (document.IsNull()) throw InputError(fmt::format("{} holds no run", file));
  if (is_text(format)) {
    fmt::print("{}  bag {}\n", text, file);
  } else {
    print_document(document, format);
  }
  if (!complete) throw std::runtime_error(fmt::format("{} is not complete", file));
}

/// Goes on in a process of its own with a bound on its memory, and ends this one as that ends: a
/// damaged size in a bag may make rosbag ask for more than there is, or read where nothing is.
/// @throw std::runtime_error when that process was killed.
void go_on_in_a_child(const std::string& file) {
  constexpr rlim_t kMostMemory = rlim_t{8} << 30U;  // bytes
  const pid_t child = fork();
  if (child == 0) {
    const rlimit bound{kMostMemory, kMostMemory};
    setrlimit(RLIMIT_AS, &bound);
    return;
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) {
    throw std::runtime_error(fmt::format("no process could be started to read {}", file));
  }
  if (WIFSIGNALED(status)) {
    throw std::runtime_error(
        fmt::format("{} is damaged: reading it ended with signal {}", file, WTERMSIG(status)));
  }
  std::exit(WEXITSTATUS(status));
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  CLI::App app("Analyses a recorded series and counts its messages.", "analyse_bag");
  std::string file;
  app.add_option("bag", file, "the bag")->required();
  impact::ElasticParameters elastic;
  constexpr double kHighestModulus = impact::ElasticParameters::kHighestModulus;
  constexpr double kHighestRatio = impact::ElasticParameters::kHighestRatio;
  app.add_option("--young-modulus", elastic.young_modulus, "E of the disk, M c^2/R^2")
      ->check(CLI::Range(std::numeric_limits<double>::min(), kHighestModulus));
  app.add_option("--poisson-ratio", elastic.poisson_ratio, "of the disk")
      ->check(CLI::Range(-kHighestRatio, kHighestRatio));
  impact::Format format = impact::Format::kAuto;
  impact::offer_formats(app, format);
  console_bridge::noOutputHandler();  // what it would say is in the exception
  return impact::run_tool(app, argc, argv, [&] {
    impact::go_on_in_a_child(file);
    impact::analyse(file, elastic, format);
  });
}
