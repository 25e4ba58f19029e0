#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <functional>
#include <stdexcept>

#include "lattice/input_error.hpp"

namespace impact {

/// Parses the command line, runs `body` and returns the exit code of the program: 0 when done, 2
/// after bad input, 1 after any other exception. An error is one line on stderr.
inline int run_tool(CLI::App& app, int argc, char** argv, const std::function<void()>& body) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "{}: {} (--help tells more)\n", app.get_name(), shown(error.what()));
    return 2;
  }
  try {
    body();
    if (std::fflush(stdout) != 0) throw std::runtime_error("the result could not be written");
    return 0;
  } catch (const InputError& error) {
    fmt::print(stderr, "{}: {}\n", app.get_name(), error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", app.get_name(), error.what());
    return 1;
  }
}

}  // namespace impact
