#include "nodes/analysis_node.hpp"

#include <fmt/format.h>
#include <lattice_impact/Acknowledged.h>

#include <algorithm>
#include <boost/function.hpp>
#include <stdexcept>

#include "nodes/program.hpp"

namespace impact {

AnalysisNode::AnalysisNode(const AnalysisNodeParameters& parameters)
    : parameters_(parameters),
      readers_(node_, parameters.wait_for),
      strain_(readers_.advertise<lattice_impact::Strain>("strain")),
      restitution_(readers_.advertise<lattice_impact::Restitution>("restitution", true)),
      law_fit_(readers_.advertise<lattice_impact::LawFit>("law_fit", true)),
      acknowledged_(node_.advertise<lattice_impact::Acknowledged>("acknowledged", 0, true)),
      fits_(parameters.elastic, [this](const lattice_impact::LawFit& law) { publish(law); }),
      analysis_({[this](const lattice_impact::Strain& strain) { publish(strain); },
                 [this](const lattice_impact::Restitution& result) { publish(result); },
                 [this](const ClosedRun& run) { fits_.add(run); },
                 [this](std::uint32_t run, std::uint32_t sequence) { acknowledge(run, sequence); },
                 [this](const std::string& problem) {
                   complete_ = false;
                   ROS_ERROR("%s", problem.c_str());
                 }}) {}

bool AnalysisNode::run() {
  readers_.wait(parameters_.timeout);
  subscribe<lattice_impact::Lattice>("lattice");
  subscribe<lattice_impact::ParticleStates>("particle_states");
  subscribe<lattice_impact::ContactForces>("contact_forces");
  subscribe<lattice_impact::RunStatus>("run_status");

  while (!asked_to_end() && !(parameters_.exit_when_done && analysis_.done())) {
    serve_callbacks();
    if (analysis_.waits_for_missing() && source_.silence() > parameters_.patience) {
      analysis_.close_ended();
    }
    if (parameters_.exit_when_done && nothing_more_comes()) break;
  }
  if (parameters_.exit_when_done && !source_.has_spoken() && !asked_to_end()) {
    throw std::runtime_error(fmt::format("no message for {} s (timeout)", parameters_.timeout));
  }
  analysis_.close();
  if (parameters_.exit_when_done) wait_for_publishers_to_go();
  linger();
  return complete_;
}

template <class Message>
void AnalysisNode::subscribe(const std::string& topic) {
  using Event = ros::MessageEvent<const Message>;
  const boost::function<void(const Event&)> take = [this](const Event& event) {
    source_.note(event.getPublisherName());
    analysis_.add(*event.getMessage());
  };
  subscribers_.push_back(node_.subscribe<const Event&>(topic, 0, take, ros::VoidConstPtr(),
                                                       ros::TransportHints().tcpNoDelay()));
}

template <class Message>
void AnalysisNode::publish(const ros::Publisher& publisher, const Message& message) {
  publisher.publish(message);
  ++results_[publisher.getTopic()];
}

void AnalysisNode::publish(const lattice_impact::Strain& strain) {
  publish(strain_, strain);
  if (strain.at_rest != 0) {
    ROS_INFO("run %u: at rest with strain %.6g R, wall force %.6g M c^2/R", strain.run,
             strain.strain, strain.force);
  }
}

void AnalysisNode::publish(const lattice_impact::Restitution& restitution) {
  publish(restitution_, restitution);
  if (restitution.complete != 0) {
    ROS_INFO("run %u: velocity %.6g c, restitution %.9g +- %.1e, contact duration %.6g R/c",
             restitution.run, -restitution.velocity_before, restitution.restitution,
             restitution.error.restitution, restitution.contact_duration);
  }
}

void AnalysisNode::publish(const lattice_impact::LawFit& law) {
  publish(law_fit_, law);
  if (law.x.size() > 1) ROS_INFO("run %u: %s", law.run, outcome(law).c_str());
}

void AnalysisNode::acknowledge(std::uint32_t run, std::uint32_t sequence) {
  if (analysis_.is_open(run) && sequence % Pacing::kStep != 0) return;
  lattice_impact::Acknowledged message;
  message.reader = ros::this_node::getName();
  message.run = run;
  message.sequence = sequence;
  for (const ros::Publisher& publisher : {strain_, restitution_, law_fit_}) {
    message.result_topics.push_back(publisher.getTopic());
    message.results.push_back(results_[publisher.getTopic()]);
  }
  acknowledged_.publish(message);
}

bool AnalysisNode::is_alone() const {
  const bool unlinked = std::all_of(subscribers_.begin(), subscribers_.end(),
                                    [](const auto& link) { return link.getNumPublishers() == 0; });
  return unlinked || !source_.is_alive();
}

/// The simulation waits until the results are taken in by the readers that it has.
void AnalysisNode::wait_for_publishers_to_go() {
  const ros::WallTime start = ros::WallTime::now();
  while (!is_alone() && !asked_to_end() &&
         (ros::WallTime::now() - start).toSec() < parameters_.timeout) {
    serve_callbacks();
  }
}

/// Where readers were named, until the last subscriber has gone.
void AnalysisNode::linger() {
  const bool for_readers = !parameters_.wait_for.empty();
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(parameters_.linger);
  while (ros::ok() && ros::WallTime::now() < end &&
         !(for_readers && readers_.subscribers().empty())) {
    serve_callbacks();
  }
}

bool AnalysisNode::nothing_more_comes() const {
  if (!source_.has_spoken()) return source_.silence() > parameters_.timeout;
  return source_.silence() > parameters_.patience && is_alone();
}

}  // namespace impact
