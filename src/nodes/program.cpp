#include "nodes/program.hpp"

#include <fmt/format.h>
#include <ros/callback_queue.h>
#include <ros/network.h>
#include <ros/ros.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "lattice/input_error.hpp"
#include "output/interruption.hpp"
#include "scene/keys.hpp"
#include "scene/short_keys.hpp"
#include "scene/version.hpp"

namespace impact {
namespace {

/// Before ros::init(), which waits for a master without end where a parameter is among the
/// arguments.
void find_master(int argc, char** argv) {
  const std::string key = "__master:=";
  const char* const variable = std::getenv("ROS_MASTER_URI");
  std::string uri = variable == nullptr ? "" : variable;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.compare(0, key.size(), key) == 0) uri = argument.substr(key.size());
  }
  if (uri.empty()) throw InputError("ROS_MASTER_URI: got nothing, allowed: a ROS master's address");
  std::string host;
  std::uint32_t port = 0;
  XmlRpc::XmlRpcValue request;
  request[0] = argv[0];
  XmlRpc::XmlRpcValue answer;
  const bool is_there =
      ros::network::splitURI(uri, host, port) &&
      XmlRpc::XmlRpcClient(host.c_str(), static_cast<int>(port)).execute("getPid", request, answer);
  if (!is_there) throw std::runtime_error("no ROS master at " + uri);
}

/// Whether the arguments ask for it, and then prints it.
bool tell(int argc, char** argv, const NodeDescription& node) {
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--version") {
      fmt::print("{} {}\n", node.name, version());
      return true;
    }
    if (argument == "--help" || argument == "-h") {
      fmt::print("{}\n\nTopics, below the node's namespace:\n{}{}{}", node.purpose, node.topics,
                 node.parameters.empty()
                     ? ""
                     : "\nPrivate parameters (--check key=value … only says whether they can be "
                       "read):\n",
                 node.parameters);
      return true;
    }
  }
  return false;
}

/// Whether the arguments ask for it.
bool check(int argc, char** argv, const NodeDescription& node) {
  if (argc < 2 || std::string(argv[1]) != "--check" || !node.check) return false;
  FlatTree keys;
  for (int i = 2; i < argc; ++i) {
    const auto& [key, value] = parse_assignment(argv[i]);
    keys[key].reset(parse_value(key, value));
  }
  node.check(keys);
  return true;
}

}  // namespace

bool asked_to_end() { return interrupted() || !ros::ok(); }

void serve_callbacks() {
  constexpr double kPoll = 0.02;  // s
  ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(kPoll));
}

int run_node(int argc, char** argv, const NodeDescription& node, const std::function<int()>& body) {
  if (tell(argc, argv, node)) return 0;
  try {
    if (check(argc, argv, node)) return 0;
    find_master(argc, argv);
    ros::init(argc, argv, node.name, ros::init_options::NoSigintHandler);
    take_interruptions();
    return body();
  } catch (const InputError& error) {
    fmt::print(stderr, "{}: {}\n", node.name, error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", node.name, printable(error.what()));
    return 1;
  }
}

}  // namespace impact
