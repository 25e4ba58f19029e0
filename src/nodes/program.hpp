#pragma once

#include <functional>

namespace impact {

/// True after SIGINT or SIGTERM, or when the ROS master has asked this node to end. A node then
/// finishes what it has begun and closes its files.
bool interrupted();

/// Initialises ROS under this node name, with signals handled by interrupted(), runs `body` and
/// returns the exit code of the program: what `body` returns, 2 after an InputError, 1 after any
/// other exception, without a master at once. An error is one line on stderr.
int run_node(int argc, char** argv, const char* name, const std::function<int()>& body);

}  // namespace impact
