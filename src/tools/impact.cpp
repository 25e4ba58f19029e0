// One run of a scene without a ROS master: its result on stdout, progress on stderr.

#include <malloc.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lattice/lammps_writing.hpp"
#include "output/interruption.hpp"
#include "output/output_folder.hpp"
#include "output/program.hpp"
#include "output/progress_bar.hpp"
#include "output/result_text.hpp"
#include "run/compose.hpp"
#include "run/forecast.hpp"
#include "scene/scene_parameters.hpp"
#include "scene/short_keys.hpp"
#include "series/convergence_study.hpp"

namespace impact {
namespace {

struct Options {
  std::string folder;     ///< empty: none
  std::string real_disk;  ///< empty: none
  bool keep_states = false;
  Format format = Format::kAuto;
};

/// What all runs of a study have done, and what is left as far as it is known, in steps.
class Work {
 public:
  void note(const ConvergenceStudy& study) {
    const Run& run = study.run();
    if (study.runs() != run_) {
      run_ = study.runs();
      before_ = done_;
    }
    done_ = before_ + static_cast<double>(run.state().step);
    const double time = run.expected_time();
    total_ = before_ + time / run.system().step_size();
    for (const Resolution& later : study.later_resolutions()) total_ += time / later.step;
  }

  double done() const { return done_; }
  double total() const { return total_; }

 private:
  int run_ = 0;
  double before_ = 0.0;  ///< the present run
  double done_ = 0.0;
  double total_ = 0.0;
};

std::string what_is_done(const ConvergenceStudy& study) {
  const Run& run = study.run();
  std::string place =
      fmt::format("{:.3g} of about {:.2g} R/c", run.state().time, run.expected_time());
  if (study.runs() == 1) return place;
  return fmt::format("run {}, with finer steps, to confirm the error: {}", study.runs(), place);
}

void perform(ConvergenceStudy& study) {
  ProgressLine progress("impact", "steps");
  Work work;
  const auto stop = [&] {
    if (!study.scene().is_static()) {
      work.note(study);
      progress.show(work.done(), work.total(), what_is_done(study));
    }
    return interrupted();
  };
  while (!study.finished()) {
    study.advance(stop);
    if (interrupted()) throw std::runtime_error("interrupted");
  }
}

void tell_if_long(const ConvergenceStudy& study) {
  const Run& run = study.run();
  const Forecast expected =
      forecast(study.scene(), run.lattice().points.rows(), run.system().field().other_points());
  if (expected.seconds <= kWorthTelling) return;
  fmt::print(stderr, "impact: this scene will take about {}\n", text(expected));
}

/// Where a large lattice was made, the heap is left with holes that its runs would not fill but add
/// to. From here on large arrays have pages of their own.
void give_back_freed_memory() {
  constexpr int kLarge = 4 << 20;  // bytes
  malloc_trim(0);
  mallopt(M_MMAP_THRESHOLD, kLarge);
}

/// Of the body of this number; 0: the disk.
std::string lattice_file(std::size_t body) {
  return (body == 0 ? "lattice" : name_of_body(body)) + ".data";
}

/// Where the results go; removes what is unfinished at its end.
struct Output {
  explicit Output(const std::string& path)
      : folder(path),
        files(path, {"result.yaml", "scene.yaml", "history.csv", lattice_file(0), lattice_file(1),
                     lattice_file(2), lattice_file(3), kStates}) {}
  static constexpr const char* kStates = "states.lammpstrj";
  OutputFolder folder;
  ResultFiles files;
};

void write_result(const ConvergenceStudy& study, const std::string& result, const History& history,
                  ResultFiles& files) {
  const double mass = study.run().system().field().point_mass;
  files.write("result.yaml", result);
  files.write("scene.yaml", to_yaml(study.scene()));
  files.write("history.csv", history.csv());
  const std::vector<BodyOfScene>& bodies = study.run().bodies();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    write_lammps_data(bodies[k].lattice, mass, files.beside(lattice_file(k)));
  }
  files.take_their_places();
}

void check(const FlatTree& keys) {
  for (const Scene& scene : parse_series(keys)) {
    refuse_impossible(scene);
  }
}

/// How the result came about, in a line.
std::string account(const ConvergenceStudy& study) {
  const Run& run = study.run();
  const std::string method = name_of(run.integrator());
  const std::string time = fmt::format("{:.2g} s", study.wall_time());
  if (study.scene().is_static()) {
    return fmt::format("  by {}: {} iterations, {}\n", method, run.state().step, time);
  }
  const std::string runs =
      study.runs() == 1 ? ""
                        : fmt::format(", the last of {} runs that show the error", study.runs());
  return fmt::format("  by {}: {} steps of {:.3g} R/c{}, {}\n", method, run.state().step,
                     run.system().step_size(), runs, time);
}

std::string text_of(const ConvergenceStudy& study, const Result& result,
                    const std::optional<SiUnits>& si) {
  const Scene& scene = study.scene();
  return fmt::format("{}\n{}{}{}", title(scene), result_block(result, scene, si), account(study),
                     si ? "  SI for " + si->origin() + "\n" : "");
}

void perform(const FlatTree& keys, const Options& options) {
  if (options.keep_states && options.folder.empty()) throw InputError("--states needs --output");
  const Scene scene = parse_single_scene(keys);
  std::optional<SiUnits> si;
  if (!options.real_disk.empty()) si.emplace(parse_real_disk(options.real_disk), scene);
  std::optional<Output> output;
  std::optional<History> history;
  if (!options.folder.empty()) {
    take_interruptions();
    output.emplace(options.folder);
    history.emplace(options.keep_states ? output->files.beside(Output::kStates) : "");
  }
  const std::shared_ptr<const Composition> composition = compose_shared(scene);
  give_back_freed_memory();
  ConvergenceStudy study(scene, composition, history ? &*history : nullptr);
  tell_if_long(study);
  perform(study);

  const Result result = study.result();
  YAML::Node document = to_yaml(result);
  if (si) document["si"] = si_values(result, scene, *si);
  if (is_text(options.format)) {
    fmt::print("{}", text_of(study, result, si));
    if (output) fmt::print("  files in {}\n", options.folder);
  } else {
    print_document(document, options.format);
  }
  if (!output) return;
  history->close();
  write_result(study, YAML::Dump(document) + "\n", *history, output->files);
}

void list_keys(const FlatTree& keys) {
  fmt::print("{}", parameter_list(scene_parameters(), parse_single_scene(keys)));
}

}  // namespace
}  // namespace impact

int main(int argc, char** argv) {
  CLI::App app("Simulates one scene and prints what came out.", "impact");
  std::string scene_file;
  std::vector<std::string> assignments;
  impact::Options options;
  bool check_only = false;
  bool list_only = false;
  app.add_option("scene", scene_file,
                 "collision, contact, absorbing_wall, stretch, or a scene file")
      ->required();
  app.add_option("assignments", assignments,
                 "key=value, replaces that key of the scene; velocity stands for impact.velocity "
                 "where no other key ends so");
  app.add_flag("--keys", list_only, "only list the keys of the scene");
  app.add_flag("--check", check_only,
               "only say whether the scene can be read; a list of values is a series");
  app.add_option("--output", options.folder,
                 "folder for result.yaml, scene.yaml, history.csv, lattice.data and wall.data");
  app.add_flag("--states", options.keep_states,
               "also all states at the output times, into states.lammpstrj, a LAMMPS dump");
  app.add_option("--si", options.real_disk,
                 "also in SI, for a disk like radius=0.05,density=1100,young=5e6[,thickness=0.01] "
                 "or with mass, wave_speed instead; see the program units");
  impact::offer_formats(app, options.format);
  return impact::run_tool(app, argc, argv, [&] {
    const impact::FlatTree keys = impact::keys_of_scene(scene_file, assignments);
    if (list_only) return impact::list_keys(keys);
    check_only ? impact::check(keys) : impact::perform(keys, options);
  });
}
