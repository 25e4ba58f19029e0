#include "tools/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tools/restitution_yaml.hpp"

namespace impact {
namespace {

constexpr const char* kHistoryHeader =
    "time [R/c],strain [R],force [M c^2/R],kinetic [M c^2],bonds [M c^2],wall [M c^2],"
    "load [M c^2],dissipated [M c^2]\n";

/// The line of the present state in history.csv.
std::string history_line(const Run& run, const Strain& strain, double force) {
  const EnergyLedger ledger = run.simulation().ledger();
  return fmt::format("{},{},{},{},{},{},{},{}\n", run.state().time, strain.strain(), force,
                     ledger.kinetic(), ledger.bonds, ledger.wall, ledger.load, ledger.dissipated);
}

/// A quantity that is a real number.
template <class Number>
Quantity number(std::string key, Number value) {
  return {std::move(key), [value](const Experiment& e) { return exact(value(e)); }};
}

std::vector<Quantity> impact_quantities() {
  std::vector<Quantity> list;
  list.push_back(number("velocity", [](const auto& e) { return e.scene().impact.velocity; }));
  for (const auto& [key, member] : restitution_keys<Restitution>()) {
    list.push_back(
        number(key, [member = member](const auto& e) { return e.restitution().*member; }));
  }
  list.push_back(
      number("restitution_bound", [](const auto& e) { return e.run().restitution_bound(); }));
  return list;
}

std::vector<Quantity> contact_quantities(const Scene& scene) {
  std::vector<Quantity> list;
  list.push_back(number("P", [](const auto& e) { return e.scene().load.p; }));
  list.push_back(number("strain", [](const auto& e) { return e.strain().strain(); }));
  list.push_back(
      number("strain_from_radius", [](const auto& e) { return e.strain().strain_from_radius(); }));
  list.push_back(number("wall_force", [](const auto& e) {
    return e.run().simulation().field().wall->total_force();
  }));
  list.push_back(number("rotation", [](const auto& e) { return e.strain().rotation; }));
  if (scene.load.hold_rotation) {
    list.push_back(number(
        "hold_torque", [](const auto& e) { return e.run().simulation().field().hold->torque(); }));
  }
  list.push_back(number("largest_static_force",
                        [](const auto& e) { return e.run().simulation().largest_static_force(); }));
  return list;
}

/// What every result ends with.
std::vector<Quantity> run_quantities() {
  std::vector<Quantity> list;
  list.push_back(number("energy_error", [](const auto& e) { return e.run().energy_error(); }));
  list.push_back({"integrator", [](const auto& e) { return YAML::Node(e.run().integrator()); }});
  list.push_back(number("step", [](const auto& e) { return e.run().simulation().step_size(); }));
  list.push_back({"steps", [](const auto& e) { return YAML::Node(e.run().state().step); }});
  list.push_back(number("wall_time", [](const auto& e) { return e.wall_time(); }));
  list.push_back({"flags", [](const auto& e) { return flag_list(e.run().flags()); }});
  return list;
}

}  // namespace

Experiment::Experiment(const Scene& scene, bool keep_history)
    : scene_(scene), run_(scene), strain_meter_(run_.lattice().points) {
  if (keep_history) history_ = kHistoryHeader;
  take_in();
}

void Experiment::advance(const std::function<bool()>& stop) {
  run_.advance(stop);
  take_in();
}

void Experiment::take_in() {
  const ContactReport report = run_.take_contact_report();
  analysis_.add(run_.state());
  analysis_.add(report);
  if (!history_.empty()) history_ += history_line(run_, strain(), report.total.y());
}

Restitution Experiment::restitution() const {
  const auto& flags = run_.flags();
  const bool separated = std::find(flags.begin(), flags.end(), "not_separated") == flags.end();
  return analysis_.restitution(separated);
}

double Experiment::wall_time() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

YAML::Node Experiment::result() const {
  YAML::Node result;
  for (const Quantity& quantity : quantities(scene_)) {
    result[quantity.key] = quantity.value(*this);
  }
  return result;
}

std::vector<Quantity> quantities(const Scene& scene) {
  std::vector<Quantity> list =
      scene.kind == SceneKind::kCollision ? impact_quantities() : contact_quantities(scene);
  for (Quantity& quantity : run_quantities()) list.push_back(std::move(quantity));
  return list;
}

}  // namespace impact
