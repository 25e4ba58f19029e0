// The figures of the paper and oblique impacts, over an ensemble of lattices, as CSV and as plots.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "output/interruption.hpp"
#include "output/output_folder.hpp"
#include "output/program.hpp"
#include "reproduction/oblique.hpp"
#include "reproduction/plotting.hpp"
#include "reproduction/reproduction.hpp"
#include "series/shards.hpp"
#include "tools/sharding.hpp"

namespace impact {
namespace {

void reproduce_paper(const std::string& figure, const Reproduction& reproduction) {
  const bool all = figure == "all";
  const Material material = measure_material(reproduction);
  break_off_if_interrupted();
  if (all) draw_lattices(reproduction);
  if (all || figure == "figure2") reproduce_figure2(reproduction, material);
  if (all || figure == "figure3") reproduce_figure3(reproduction, material);
  if (all || figure == "figure6") reproduce_figure6(reproduction, material);
}

void reproduce(const std::string& figure, const Reproduction& reproduction) {
  const OutputFolder output(reproduction.folder);
  take_interruptions();
  if (figure == "oblique") {
    reproduce_oblique(reproduction);
  } else {
    reproduce_paper(figure, reproduction);
  }
  break_off_if_interrupted();
  plot(reproduction.folder, figure);
}

/// What each figure simulates over so many lattices.
const std::map<std::string, std::vector<Scene> (*)(int lattices)> kSeries{
    {"figure2", scenes_of_figure2},
    {"figure3", scenes_of_figure3},
    {"figure6", scenes_of_figure6},
    {"oblique", [](int lattices) { return scenes_of_oblique(lattices); }}};

ShardedSeries shards_of(const std::string& figure, const Reproduction& reproduction) {
  const auto series = kSeries.find(figure);
  if (series == kSeries.end()) {
    throw InputError(figure +
                     ": is not divided into shards, allowed: figure2, figure3, figure6 or oblique");
  }
  return {series->second(reproduction.lattices), reproduction.folder / (figure + "_shards")};
}

void reproduce_in_shards(const std::string& figure, const Reproduction& reproduction,
                         const Sharding& sharding) {
  const ShardedSeries shards = shards_of(figure, reproduction);
  if (sharding.status) {
    print_status(shards, sharding.format);
  } else if (sharding.collect) {
    shards.collect(file_of_runs(reproduction, figure));
    reproduce(figure, reproduction);
  } else {
    simulate_shard("reproduce", shards, parse_shard(sharding.shard), reproduction.jobs);
  }
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  CLI::App app(
      "Reproduces the figures of the paper, and oblique impacts, over an ensemble of lattices, as "
      "CSV, SVG and PNG. An "
      "interrupted command is taken up again where it was.",
      "reproduce");
  std::string figure;
  impact::Reproduction reproduction;
  reproduction.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  app.add_option("figure", figure,
                 "figure2, figure3, figure6, all of them (also figures 1 and 4), or oblique: "
                 "impacts at an angle on soft walls")
      ->required()
      ->check(
          CLI::IsMember(std::set<std::string>{"figure2", "figure3", "figure6", "oblique", "all"}));
  std::string folder;
  app.add_option("--output", folder, "folder for the results")->required();
  app.add_option("--lattices", reproduction.lattices, "size of the ensemble")
      ->capture_default_str()
      ->check(CLI::Range(2, 100000));
  app.add_option("--jobs", reproduction.jobs, "threads")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  impact::Sharding sharding;
  impact::offer_shards(app, sharding);
  return impact::run_tool(app, argc, argv, [&] {
    reproduction.folder = folder;
    if (sharding.is_wanted()) {
      impact::reproduce_in_shards(figure, reproduction, sharding);
    } else {
      impact::reproduce(figure, reproduction);
    }
  });
}
