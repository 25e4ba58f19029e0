// What an impact in LAMMPS came to, in the numbers of `impact`.

#include <filesystem>
#include <string>

#include "measure/impact_answer.hpp"
#include "output/program.hpp"
#include "run/lammps_course.hpp"
#include "run/lammps_scene.hpp"
#include "scene/keys.hpp"
#include "scene/scene_parameters.hpp"

namespace impact {
namespace {

Scene scene_in(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "scene.yaml";
  Scene scene = scene_for_lammps(parse_single_scene(load_keys(file)));
  if (!scene.numerics.step) {
    throw InputError(
        fmt::format("{}: numerics.step: got auto, allowed: the step of the run", file.string()));
  }
  return scene;
}

Result result_of(const LammpsAnswer& answer, const Scene& scene) {
  Result result;
  result.entries.emplace_back("velocity", scene.impact.velocity);
  for (const auto& [key, member] : impact_numbers<Restitution>()) {
    if (disk_of(key) != 0 || is_of_row(key)) continue;
    if (is_of_sliding(key) && !scene.impact.slides()) continue;
    result.entries.emplace_back(key, answer.impact.*member);
  }
  result.entries.emplace_back("energy_error", answer.energy_error);
  result.entries.emplace_back("integrator", name_of(scene.numerics.integrator));
  result.entries.emplace_back("step", *scene.numerics.step);
  result.entries.emplace_back("steps", static_cast<double>(answer.steps));
  result.entries.emplace_back("flags", answer.flags);
  return result;
}

void analyse(const std::string& folder, Format format) {
  const Scene scene = scene_in(folder);
  const LammpsAnswer answer = answer_of(read_lammps_course(folder, *scene.numerics.step), scene);
  const Result result = result_of(answer, scene);
  if (!is_text(format)) return print_document(to_yaml(result), format);
  fmt::print("{}\n{}  by LAMMPS: {} steps of {:.3g} R/c\n", title(scene),
             result_block(result, scene), answer.steps, *scene.numerics.step);
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  CLI::App app("Prints what an impact in LAMMPS came to.", "from_lammps");
  std::string folder;
  impact::Format format = impact::Format::kAuto;
  app.add_option("folder", folder, "folder of to_lammps, in which LAMMPS has run")->required();
  impact::offer_formats(app, format);
  return impact::run_tool(app, argc, argv, [&] { impact::analyse(folder, format); });
}
