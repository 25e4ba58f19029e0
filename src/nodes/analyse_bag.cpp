// The analysis node's numbers, straight from a bag, and whether the bag holds all that was
// published.

#include <console_bridge/console.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <limits>
#include <string>

#include "nodes/bag_pipeline.hpp"
#include "output/program.hpp"

namespace impact {
namespace {

void analyse(const std::string& file, const ElasticParameters& elastic, Format format) {
  const auto pipelines = read_bag(file, elastic, [](const std::string& problem) {
    fmt::print(stderr, "analyse_bag: {}\n", problem);
  });
  bool complete = true;
  YAML::Node document;
  std::string text;
  for (const auto& [name_space, pipeline] : pipelines) {
    if (!pipeline.has_runs()) continue;
    if (is_text(format)) {
      text += fmt::format("{}: {}", name_space, pipeline.text());
    } else {
      document[name_space] = pipeline.document();
    }
    complete = complete && pipeline.complete();
  }
  if (document.IsNull() && text.empty()) throw InputError(fmt::format("{} holds no run", file));
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
