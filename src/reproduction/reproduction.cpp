#include "reproduction/reproduction.hpp"

#include <stdexcept>

#include "output/interruption.hpp"
#include "output/progress_bar.hpp"
#include "series/series.hpp"

namespace impact {

std::filesystem::path file_of_runs(const Reproduction& reproduction, const std::string& name) {
  return reproduction.folder / (name + "_runs.csv");
}

std::vector<Row> simulate(const Reproduction& reproduction, const std::string& name,
                          const std::vector<Scene>& scenes) {
  ProgressBar bar("reproduce: " + name, scenes.size());
  return run_series(
      scenes, file_of_runs(reproduction, name),
      {reproduction.jobs, [&bar](std::size_t /*rows*/, std::size_t runs) { bar.show(runs); },
       interrupted});
}

void break_off_if_interrupted() {
  if (interrupted()) throw std::runtime_error("interrupted; the same command goes on from there");
}

std::vector<Scene> with_seeds(const std::vector<Scene>& scenes, int lattices) {
  std::vector<Scene> all;
  all.reserve(scenes.size() * static_cast<std::size_t>(lattices));
  for (int seed = 1; seed <= lattices; ++seed) {
    for (Scene scene : scenes) {
      scene.seed = static_cast<std::uint64_t>(seed);
      all.push_back(scene);
    }
  }
  return all;
}

}  // namespace impact
