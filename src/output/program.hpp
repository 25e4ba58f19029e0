#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "lattice/input_error.hpp"
#include "output/result_text.hpp"
#include "scene/suggestion.hpp"
#include "scene/version.hpp"

namespace impact {

/// " (did you mean --output?)" for a word that is no option of the program.
inline std::string suggested_option(CLI::App& app) {
  std::vector<std::string> options;
  for (const CLI::Option* const option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  }
  for (const std::string& word : app.remaining()) {
    if (word.rfind("--", 0) == 0) return suggestion(word.substr(0, word.find('=')), options);
  }
  return {};
}

/// How a result is printed.
enum class Format {
  kAuto,  ///< text to a terminal, else YAML
  kText,
  kYaml,
  kJson
};

/// Adds --text, --yaml and --json, which set `format`.
inline void offer_formats(CLI::App& app, Format& format) {
  const auto offer = [&](const std::string& name, Format chosen, const std::string& meaning) {
    return app.add_flag_callback(
        name, [&format, chosen] { format = chosen; }, meaning);
  };
  CLI::Option* const text =
      offer("--text", Format::kText, "the result as text, as to a terminal, in a pipe too");
  CLI::Option* const yaml =
      offer("--yaml", Format::kYaml, "the result as YAML, as in a pipe, to a terminal too");
  CLI::Option* const json = offer("--json", Format::kJson, "the result as JSON");
  text->excludes(yaml)->excludes(json);
  yaml->excludes(json);
}

/// Whether a result of this format is text on stdout as it is.
inline bool is_text(Format format) {
  return format == Format::kText || (format == Format::kAuto && isatty(STDOUT_FILENO) != 0);
}

/// Prints the tree as JSON, or else as YAML.
inline void print_document(const YAML::Node& tree, Format format) {
  fmt::print("{}\n", format == Format::kJson ? to_json(tree) : YAML::Dump(tree));
}

/// Parses the command line, runs `body` and returns the exit code of the program: 0 when done, 2
/// after bad input, 1 after any other exception. An error is one line on stderr.
inline int run_tool(CLI::App& app, int argc, char** argv, const std::function<void()>& body) {
  app.set_version_flag("--version", fmt::format("{} {}", app.get_name(), version()));
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "{}: {}{} (--help tells more)\n", app.get_name(), shown(error.what()),
               suggested_option(app));
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
    fmt::print(stderr, "{}: {}\n", app.get_name(), printable(error.what()));
    return 1;
  }
}

}  // namespace impact
