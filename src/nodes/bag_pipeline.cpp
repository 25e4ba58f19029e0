#include "nodes/bag_pipeline.hpp"

#include <fmt/format.h>
#include <lattice_impact/Scalars.h>

#include <cmath>
#include <exception>
#include <set>
#include <stdexcept>
#include <utility>

#include "nodes/bag_reading.hpp"
#include "nodes/body_topics.hpp"
#include "nodes/law_fit_yaml.hpp"
#include "output/result_text.hpp"
#include "output/text_table.hpp"
#include "scene/keys.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

/// The topic of a message, of whichever body.
template <class Message>
constexpr const char* kTopic = nullptr;
template <>
constexpr const char* kTopic<lattice_impact::Lattice> = "lattice";
template <>
constexpr const char* kTopic<lattice_impact::ParticleStates> = "particle_states";
template <>
constexpr const char* kTopic<lattice_impact::ContactForces> = "contact_forces";
template <>
constexpr const char* kTopic<lattice_impact::RunStatus> = "run_status";
template <>
constexpr const char* kTopic<lattice_impact::Scalars> = "scalars";
template <>
constexpr const char* kTopic<lattice_impact::Strain> = "strain";
template <>
constexpr const char* kTopic<lattice_impact::Restitution> = "restitution";
template <>
constexpr const char* kTopic<lattice_impact::LawFit> = "law_fit";

YAML::Node counts(std::uint64_t published, std::uint64_t recorded) {
  YAML::Node node;
  node["published"] = published;
  node["recorded"] = recorded;
  node.SetStyle(YAML::EmitterStyle::Flow);
  return node;
}

std::uint32_t run_of(const Result& result) {
  return static_cast<std::uint32_t>(result.number("run"));
}

/// The numbers that say something of this impact: those of sliding where the disk slides, those of
/// other disks where it met them.
std::set<std::string> telling(const lattice_impact::Restitution& impact) {
  const bool slides = !std::isnan(impact.tangential_restitution);
  std::set<std::string> keys;
  for (const auto& [key, member] : impact_numbers<lattice_impact::Restitution>()) {
    const bool is_of_others = disk_of(key) != 0 || is_of_row(key);
    const bool tells = is_of_others ? !std::isnan(impact.*member) : slides || !is_of_sliding(key);
    if (tells) keys.insert(key);
  }
  return keys;
}

/// Adds what an impact did; `suffix` follows the key of each number.
template <class Numbers>
void add_impact(const Numbers& numbers, const std::string& suffix,
                const std::set<std::string>& keys, Result& result) {
  for (const auto& [key, member] : impact_numbers<Numbers>()) {
    if (keys.count(key) > 0) result.entries.emplace_back(key + suffix, numbers.*member);
  }
}

/// The namespace of the simulation that published this topic: that of the topic itself, or the one
/// above it for the topics of an elastic wall.
std::string pipeline_of(const std::string& topic, const std::set<std::string>& simulations) {
  const std::string name_space = name_space_of(topic);
  const std::string above = name_space_of(name_space);
  return simulations.count(name_space) == 0 && simulations.count(above) > 0 ? above : name_space;
}

/// All its messages, by namespace.
std::map<std::string, BagPipeline> read(const std::string& file, const ElasticParameters& elastic,
                                        const BagPipeline::Problem& problem) {
  rosbag::Bag bag;
  open_to_read(file, bag);
  std::map<std::string, BagPipeline> pipelines;
  rosbag::View view(bag);
  const std::set<std::string> name_spaces = simulations_in(view);
  for (const rosbag::MessageInstance& message : view) {
    const std::string name_space = pipeline_of(message.getTopic(), name_spaces);
    pipelines.try_emplace(name_space, name_space, elastic, problem).first->second.add(message);
  }
  return pipelines;
}

}  // namespace

BagPipeline::BagPipeline(std::string name_space, const ElasticParameters& elastic, Problem problem)
    : fits_(elastic, [this](const lattice_impact::LawFit& law) { add_result(law); }),
      analysis_({[this](const lattice_impact::Strain& strain) { add_result(strain); },
                 [this](const lattice_impact::Restitution& result) { add_result(result); },
                 [this](const ClosedRun& run) { fits_.add(run); },
                 [](std::uint32_t, std::uint32_t) {},
                 [this](const std::string& line) { report(line); }}),
      name_space_(std::move(name_space)),
      problem_(std::move(problem)) {}

template <class Message>
bool BagPipeline::is_a(const rosbag::MessageInstance& message) const {
  const std::string topic = kTopic<Message>;
  const std::string name = short_name(message);
  if (!message.isType<Message>()) return false;
  for (std::size_t body = 0; body < kMostBodies; ++body) {
    if (name == topics_of_body(body) + topic) return true;
  }
  return false;
}

template <class Message>
boost::shared_ptr<Message> BagPipeline::counted(const rosbag::MessageInstance& message) {
  if (!is_a<Message>(message)) return nullptr;
  ++recorded_[short_name(message)];
  return message.instantiate<Message>();
}

template <class Message>
bool BagPipeline::count(const rosbag::MessageInstance& message) {
  const auto content = counted<Message>(message);
  if (content) inventory_.add(short_name(message), content->run);
  return content != nullptr;
}

template <class Message>
bool BagPipeline::take(const rosbag::MessageInstance& message) {
  const auto content = counted<Message>(message);
  if (!content) return false;
  inventory_.add(short_name(message), content->run);
  analysis_.add(*content);
  return true;
}

bool BagPipeline::take_status(const rosbag::MessageInstance& message) {
  const auto content = counted<lattice_impact::RunStatus>(message);
  if (!content) return false;
  inventory_.add(*content);
  analysis_.add(*content);
  statuses_[content->run] = *content;
  return true;
}

template <class Message>
bool BagPipeline::result(const rosbag::MessageInstance& message) {
  if (!is_a<Message>(message)) return false;
  ++recorded_results_[short_name(message)];
  computed_results_.try_emplace(short_name(message), 0);
  return true;
}

void BagPipeline::add(const rosbag::MessageInstance& message) {
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

void BagPipeline::close() {
  analysis_.close();
  for (const std::string& problem : inventory_.problems()) report(problem);
  for (const auto& [topic, recorded] : recorded_results_) {
    const std::uint64_t found = computed_results_[topic];
    if (recorded != found) {
      report(fmt::format("{}: {} messages, {} from the data", topic, recorded, found));
    }
  }
}

void BagPipeline::report(const std::string& problem) {
  complete_ = false;
  problem_(fmt::format("{}: {}", name_space_, problem));
}

bool BagPipeline::is_of_wall(const std::string& topic) const {
  for (std::size_t body = 1; body < kMostBodies; ++body) {
    const std::string of_body = full_name(topics_of_body(body));
    if (topic.compare(0, of_body.size(), of_body) == 0) return true;
  }
  return false;
}

YAML::Node BagPipeline::document() const {
  YAML::Node node;
  node["topics"] = topics();
  for (const Result& result : results_) node["runs"].push_back(to_yaml(result));
  for (const auto& law : law_fits_) {
    if (law.second.x.size() > 1) node["law_fits"].push_back(to_yaml(law.second));
  }
  return node;
}

YAML::Node BagPipeline::topics() const {
  YAML::Node node;
  for (const auto& [topic, recorded] : recorded_) {
    node[full_name(topic)] = counts(inventory_.published(topic), recorded);
  }
  for (const auto& [topic, recorded] : recorded_results_) {
    node[full_name(topic)] = counts(computed_results_.at(topic), recorded);
  }
  return node;
}

std::string BagPipeline::text() const {
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

/// What is wrong with the scene of a damaged bag was reported.
Scene BagPipeline::scene_of(const Result& result) const {
  const auto status = statuses_.find(run_of(result));
  try {
    if (status != statuses_.end()) return parse_scene(parse_keys(status->second.scene, "scene"));
  } catch (const InputError&) {
  }
  Scene scene;
  scene.kind = result.has("strain") ? SceneKind::kContact : SceneKind::kCollision;
  return scene;
}

/// With what the status of the run adds.
Result BagPipeline::completed(Result result) const {
  const auto status = statuses_.find(run_of(result));
  if (status == statuses_.end()) return result;
  result.entries.emplace_back("estimated_error", status->second.estimated_error);
  if (!result.has("flags")) result.entries.emplace_back("flags", status->second.flags);
  return result;
}

std::string BagPipeline::block(const Result& result) const {
  const Scene scene = scene_of(result);
  return title(scene) + "\n" + result_block(completed(result), scene);
}

std::string BagPipeline::table_of_runs() const {
  std::string text = fmt::format("{} runs\n", results_.size());
  std::vector<Result> results;
  for (const Result& result : results_) results.push_back(completed(result));
  return text + result_table(results, scene_of(results_.front()).kind);
}

void BagPipeline::add_result(const lattice_impact::Strain& strain) {
  ++computed_results_["strain"];
  if (strain.at_rest == 0) return;
  results_.push_back({{{"run", static_cast<double>(strain.run)},
                       {"strain", strain.strain},
                       {"strain_from_radius", strain.strain_from_radius},
                       {"rotation", strain.rotation},
                       {"wall_force", strain.force}}});
}

void BagPipeline::add_result(const lattice_impact::Restitution& restitution) {
  ++computed_results_["restitution"];
  if (restitution.ended == 0) return;
  Result result{{{"run", static_cast<double>(restitution.run)},
                 {"complete", restitution.complete != 0},
                 {"velocity", std::hypot(restitution.velocity_before,
                                         restitution.tangential_velocity_before)}}};
  const std::set<std::string> keys = telling(restitution);
  add_impact(restitution, "", keys, result);
  add_impact(restitution.error, "_error", keys, result);
  result.entries.emplace_back("restitution_of_run", restitution.restitution_of_run);
  result.entries.emplace_back("restitution_of_run_error", restitution.restitution_of_run_error);
  result.entries.emplace_back("flags", restitution.flags);
  results_.push_back(std::move(result));
}

void BagPipeline::add_result(const lattice_impact::LawFit& law) {
  ++computed_results_["law_fit"];
  law_fits_[law.scene] = law;
}

// rosbag reads what the bytes say, and throws as many things as can be wrong with them.
std::map<std::string, BagPipeline> read_bag(const std::string& file,
                                            const ElasticParameters& elastic,
                                            const BagPipeline::Problem& problem) {
  try {
    auto pipelines = read(file, elastic, problem);
    for (auto& pipeline : pipelines) pipeline.second.close();
    return pipelines;
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{} is damaged: {}", file, error.what()));
  }
}

}  // namespace impact
