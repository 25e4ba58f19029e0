#include "nodes/program.hpp"

#include <fmt/format.h>
#include <ros/ros.h>

#include <csignal>
#include <cstdio>
#include <stdexcept>

#include "lattice/input_error.hpp"

namespace impact {
namespace {

volatile std::sig_atomic_t signal_received = 0;

}  // namespace

bool interrupted() { return signal_received != 0 || !ros::ok(); }

int run_node(int argc, char** argv, const char* name, const std::function<int()>& body) {
  ros::init(argc, argv, name, ros::init_options::NoSigintHandler);
  std::signal(SIGINT, [](int) { signal_received = 1; });
  std::signal(SIGTERM, [](int) { signal_received = 1; });
  try {
    if (!ros::master::check())
      throw std::runtime_error("no ROS master at " + ros::master::getURI());
    return body();
  } catch (const InputError& error) {
    fmt::print(stderr, "{}: {}\n", name, error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", name, error.what());
    return 1;
  }
}

}  // namespace impact
