// Writes an impact for LAMMPS: the disk at its start, its bonds and an input script.

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "lattice/lammps_writing.hpp"
#include "output/interruption.hpp"
#include "output/output_folder.hpp"
#include "output/program.hpp"
#include "run/lammps_course.hpp"
#include "run/lammps_scene.hpp"
#include "scene/scene_parameters.hpp"
#include "scene/short_keys.hpp"

namespace impact {
namespace {

void stop_if_interrupted() {
  if (interrupted()) throw std::runtime_error("interrupted");
}

void refuse_if_run(const std::filesystem::path& folder) {
  for (const char* const name : kLammpsOutput) {
    if (!std::filesystem::exists(folder / name)) continue;
    throw InputError(
        fmt::format("{}: LAMMPS has run here ({}); take another folder", folder.string(), name));
  }
}

void write(const Scene& scene, const Composition& composition, ResultFiles& files) {
  const Lattice& disk = composition.bodies->disk();
  Scene as_run = scene;
  as_run.numerics.step = composition.resolution.step;
  files.write("in.lammps", lammps_script(scene, composition));
  files.write("scene.yaml", to_yaml(as_run));
  write_lammps_start(disk, composition.initial.position, composition.field.point_mass,
                     files.beside("start.data"));
  stop_if_interrupted();
  write_lammps_bonds(disk.natural_lengths, scene.material.k_a, scene.material.k_b,
                     files.beside("bonds.in"));
  stop_if_interrupted();
  files.take_their_places();
}

void perform(const Scene& scene, const std::string& path) {
  refuse_if_run(path);
  take_interruptions();
  const OutputFolder folder(path);
  ResultFiles files(path, {"in.lammps", "start.data", "bonds.in", "scene.yaml"});
  const Composition composition = compose_for_lammps(scene);
  stop_if_interrupted();
  write(scene, composition, files);
  const Lattice& disk = composition.bodies->disk();
  fmt::print(
      "{} points, {} bonds, steps of {:.3g} R/c\n"
      "cd {} && mpirun -np 2 lmp -in in.lammps\n",
      disk.points.rows(), disk.bonds.size(), composition.resolution.step, path);
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  CLI::App app(
      "Writes a collision with the potential wall, without damping, for LAMMPS, which moves "
      "lattices on many processors.",
      "to_lammps");
  std::string scene_file;
  std::string folder;
  std::vector<std::string> assignments;
  app.add_option("scene", scene_file, "collision, or a scene file")->required();
  app.add_option("folder", folder,
                 "folder for in.lammps, start.data, bonds.in and scene.yaml, in which LAMMPS is "
                 "to run")
      ->required();
  app.add_option("assignments", assignments,
                 "key=value, replaces that key of the scene, as in impact");
  return impact::run_tool(app, argc, argv, [&] {
    const impact::FlatTree keys = impact::keys_of_scene(scene_file, assignments);
    impact::perform(impact::scene_for_lammps(impact::parse_single_scene(keys)), folder);
  });
}
