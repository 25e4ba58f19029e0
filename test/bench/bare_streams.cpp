// What roscpp and rosbag take by themselves: streams of the number, size and pace of the simulation
// node's, of messages prepared once, and a recorder that looks into none. See bench_publishing.

#include <lattice_impact/ContactForces.h>
#include <lattice_impact/ParticleStates.h>
#include <lattice_impact/RunStatus.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rosbag/bag.h>
#include <topic_tools/shape_shifter.h>

#include <CLI/CLI.hpp>
#include <boost/function.hpp>
#include <cstdint>
#include <ctime>
#include <string>
#include <vector>

namespace {

struct Streams {
  int runs = 40;
  std::uint32_t states = 900;
  std::size_t points = 1099;
  std::size_t contacts = 7;
  double work = 12e-6;
  double between = 10e-3;
};

/// Takes this much processor time, in s, where the simulation node computes.
void work_for(double duration) {
  const auto now = [] {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double end = now() + duration;
  while (now() < end) {
  }
}

lattice_impact::ParticleStates prepared_states(const Streams& streams) {
  lattice_impact::ParticleStates message;
  for (auto* column : {&message.x, &message.y, &message.vx, &message.vy}) {
    column->assign(streams.points, 0.1);
  }
  return message;
}

lattice_impact::ContactForces prepared_forces(const Streams& streams) {
  lattice_impact::ContactForces message;
  message.point.assign(streams.contacts, 1);
  message.fx.assign(streams.contacts, 0.1);
  message.fy.assign(streams.contacts, 0.1);
  message.sample_time.assign(2, 0.1);
  message.sample_force.assign(2, 0.1);
  return message;
}

/// Stays until it is killed.
void publish(const Streams& streams) {
  ros::NodeHandle node;
  const ros::Publisher states =
      node.advertise<lattice_impact::ParticleStates>("particle_states", 0);
  const ros::Publisher forces = node.advertise<lattice_impact::ContactForces>("contact_forces", 0);
  const ros::Publisher status = node.advertise<lattice_impact::RunStatus>("run_status", 0, true);
  const lattice_impact::ParticleStates prepared = prepared_states(streams);
  const lattice_impact::ContactForces prepared_force = prepared_forces(streams);
  lattice_impact::RunStatus end;
  end.phase = lattice_impact::RunStatus::FINISHED;
  end.states = streams.states;
  for (int run = 0; run < streams.runs; ++run) {
    work_for(streams.between);
    for (std::uint32_t state = 0; state < streams.states; ++state) {
      work_for(streams.work);
      if (states.getNumSubscribers() > 0) states.publish(prepared);
      if (forces.getNumSubscribers() > 0) forces.publish(prepared_force);
      ros::spinOnce();
    }
    end.run = static_cast<std::uint32_t>(run);
    status.publish(end);
  }
  ros::spin();
}

/// Ends when nothing has come for a second after the first message.
void record(const std::string& file) {
  using Event = ros::MessageEvent<const topic_tools::ShapeShifter>;
  ros::NodeHandle node;
  rosbag::Bag bag(file, rosbag::bagmode::Write);
  ros::WallTime latest;
  std::vector<ros::Subscriber> subscribers;
  for (const std::string topic :
       {"lattice", "particle_states", "contact_forces", "run_status", "scalars"}) {
    const boost::function<void(const Event&)> write = [&bag, &latest, topic](const Event& event) {
      latest = ros::WallTime::now();
      bag.write("/" + topic, ros::Time(latest.sec, latest.nsec), *event.getMessage(),
                event.getConnectionHeaderPtr());
    };
    subscribers.push_back(node.subscribe<const Event&>(topic, 0, write, ros::VoidConstPtr(),
                                                       ros::TransportHints().tcpNoDelay()));
  }
  while (ros::ok() && (latest.isZero() || (ros::WallTime::now() - latest).toSec() < 1.0)) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02));
  }
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "bare_streams");
  CLI::App app("Publishes streams of prepared messages, or records streams unread.");
  Streams streams;
  std::string file;
  auto* const publisher = app.add_subcommand("publish");
  publisher->add_option("--runs", streams.runs);
  publisher->add_option("--states", streams.states, "of a run");
  publisher->add_option("--points", streams.points);
  publisher->add_option("--contacts", streams.contacts);
  publisher->add_option("--work", streams.work, "s of processor time before each state");
  publisher->add_option("--between", streams.between, "s of processor time before each run");
  auto* const recorder = app.add_subcommand("record");
  recorder->add_option("file", file)->required();
  app.require_subcommand(1);
  CLI11_PARSE(app, argc, argv);
  if (*publisher) publish(streams);
  if (*recorder) record(file);
  return 0;
}
