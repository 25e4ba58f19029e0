#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "series/series_file.hpp"
#include "theory/hertz.hpp"

namespace impact {

/// Where a reproduction writes, and how large its ensembles are.
struct Reproduction {
  std::filesystem::path folder;
  int lattices = 16;  ///< seeds 1 … lattices
  int jobs = 1;       ///< threads
};

/// The runs of one figure, over all seeds, with a progress bar; they are kept in NAME_runs.csv, and
/// only those that are not there yet are simulated.
/// @throw as run_series().
std::vector<Row> simulate(const Reproduction& reproduction, const std::string& name,
                          const std::vector<Scene>& scenes);

/// Where simulate() keeps the runs of a figure.
std::filesystem::path file_of_runs(const Reproduction& reproduction, const std::string& name);

/// @throw std::runtime_error after SIGINT or SIGTERM.
void break_off_if_interrupted();

/// Each scene with the seeds 1 … lattices; a scene's own keys change fastest.
std::vector<Scene> with_seeds(const std::vector<Scene>& scenes, int lattices);

/// The elastic constants of the two recipes, with springs of k_a = 1.
struct Material {
  ElasticDisk blue_noise;
  ElasticDisk uniform;
  const ElasticDisk& of(Placement placement) const {
    return placement == Placement::kUniform ? uniform : blue_noise;
  }
};

/// The default material measured, by pulling rectangles and on periodic patches, for both
/// placements (material.csv): E and ν by pulling.
Material measure_material(const Reproduction& reproduction);

/// Figures 1 and 4: a disk pressed on the potential wall, and one at its deepest in the elastic
/// wall (figure1_points.csv, figure1_bonds.csv, and so on).
void draw_lattices(const Reproduction& reproduction);

/// Figure 2: compression against load, the fits of b, and the pressure under the contact
/// (figure2.csv, figure2_fits.csv, figure2_pressure.csv).
void reproduce_figure2(const Reproduction& reproduction, const Material& material);

/// What figures 2, 3 and 6 simulate, over all seeds.
std::vector<Scene> scenes_of_figure2(int lattices);
std::vector<Scene> scenes_of_figure3(int lattices);
std::vector<Scene> scenes_of_figure6(int lattices);

/// Figure 3: restitution against speed for seven η*, the fits of d₁ and d₂, and τ₀ (figure3.csv,
/// figure3_fits.csv, figure3_dissipation.csv).
void reproduce_figure3(const Reproduction& reproduction, const Material& material);

/// Figure 6: restitution against speed on the elastic wall, for several boundaries (figure6.csv,
/// figure6_fits.csv).
void reproduce_figure6(const Reproduction& reproduction, const Material& material);

}  // namespace impact
