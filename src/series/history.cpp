#include "series/history.hpp"

#include <fmt/format.h>

#include <iterator>
#include <stdexcept>

namespace impact {
namespace {

constexpr const char* kHeader =
    "time [R/c],strain [R],force [M c^2/R],velocity x [c],velocity y [c],translation [M c^2],"
    "rotation [M c^2],vibration [M c^2],bonds [M c^2],wall [M c^2],load [M c^2],"
    "dissipated [M c^2],wall lattice [M c^2],absorbed [M c^2],hops [M c^2]\n";

std::string csv_line(const Run& run, const Strain& strain, double force) {
  const EnergyLedger ledger = run.system().ledger();
  const Eigen::Array2d velocity = run.disk_state().velocity.colwise().mean();
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", run.state().time,
                     strain.strain(), force, velocity.x(), velocity.y(), ledger.kinetic_translation,
                     ledger.kinetic_rotation, ledger.kinetic_internal, ledger.bonds, ledger.wall,
                     ledger.load, ledger.dissipated, ledger.wall_lattice, ledger.absorbed,
                     ledger.hops);
}

void add_forces(const ContactReport& report, Eigen::Index first_row, PointArray& force) {
  for (const PointForce& contact : report.points) {
    force.row(first_row + contact.point) += contact.force.transpose();
  }
}

/// The force of the contacts on each point of all bodies.
PointArray contact_forces(const Run& run, const ContactReports& reports) {
  PointArray force = PointArray::Zero(run.state().position.rows(), 2);
  for (std::size_t k = 0; k < run.bodies().size(); ++k) {
    add_forces(reports.on(k), run.system().field().body(k).first, force);
  }
  return force;
}

/// A snapshot of a LAMMPS dump (docs.lammps.org/dump.html). The type is the number of the
/// body, 1 for the disk.
std::string snapshot(const Run& run, const ContactReports& reports) {
  const PointArray& position = run.state().position;
  const PointArray& velocity = run.state().velocity;
  const PointArray force = contact_forces(run, reports);
  const Eigen::Array<double, 1, 2> low = position.colwise().minCoeff();
  const Eigen::Array<double, 1, 2> high = position.colwise().maxCoeff();
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "ITEM: TIME\n{}\nITEM: TIMESTEP\n{}\n", run.state().time, run.state().step);
  fmt::format_to(out, "ITEM: NUMBER OF ATOMS\n{}\n", position.rows());
  fmt::format_to(out, "ITEM: BOX BOUNDS ss ss pp\n{} {}\n{} {}\n-0.5 0.5\n", low(0), high(0),
                 low(1), high(1));
  fmt::format_to(out, "ITEM: ATOMS id type x y z vx vy vz fx fy fz\n");
  for (std::size_t k = 0; k < run.bodies().size(); ++k) {
    const Body body = run.system().field().body(k);
    for (Eigen::Index i = body.first; i < body.first + body.points; ++i) {
      fmt::format_to(out, "{} {} {} {} 0 {} {} 0 {} {} 0\n", i + 1, k + 1, position(i, 0),
                     position(i, 1), velocity(i, 0), velocity(i, 1), force(i, 0), force(i, 1));
    }
  }
  return fmt::to_string(text);
}

}  // namespace

void History::start() {
  csv_ = kHeader;
  if (states_path_.empty()) return;
  states_ = std::ofstream(states_path_, std::ios::binary);
}

void History::add(const Run& run, const Strain& strain, const ContactReports& reports) {
  csv_ += csv_line(run, strain, reports.on_first.total.y());
  if (states_path_.empty()) return;
  states_ << snapshot(run, reports);
}

void History::close() {
  if (states_path_.empty()) return;
  states_.close();
  if (!states_) {
    throw std::runtime_error(fmt::format("{} cannot be written", states_path_.string()));
  }
}

}  // namespace impact
