#pragma once

#include <functional>
#include <string>

#include "scene/parameter_table.hpp"

namespace impact {

/// What a node says of itself.
struct NodeDescription {
  const char* name;
  const char* purpose;     ///< a sentence or two
  const char* topics;      ///< a line a topic
  std::string parameters;  ///< as of parameter_list(); empty: none
  /// Reads private parameters, only to see whether they can be read; empty: none.
  /// @throw InputError as read_parameters().
  std::function<void(const FlatTree&)> check = {};
};

/// True after SIGINT or SIGTERM, or when the ROS master has asked this node to end. A node then
/// finishes what it has begun and closes its files.
bool asked_to_end();

/// Hands over the messages that have come, after a short wait for the first.
void serve_callbacks();

/// Initialises ROS under the node's name, with signals handled by asked_to_end(), runs `body` and
/// returns the exit code of the program: what `body` returns, 2 after an InputError, 1 after any
/// other exception, without a master at once. An error is one line on stderr. With --help or
/// --version only prints what was asked for, and with --check key=value … only says whether these
/// private parameters can be read; neither needs a master.
int run_node(int argc, char** argv, const NodeDescription& node, const std::function<int()>& body);

}  // namespace impact
