#include <fmt/format.h>

#include "run/run.hpp"
#include "tools/reproduction.hpp"
#include "tools/table.hpp"

namespace impact {
namespace {

void add_bonds(const Lattice& lattice, Eigen::Index first_row, Table& bonds) {
  for (const Bond& bond : lattice.bonds) {
    bonds << fmt::format("{}", bond.first + first_row)
          << fmt::format("{}", bond.second + first_row);
  }
}

void write_drawing(const Run& run, const std::filesystem::path& folder, const std::string& name) {
  Table points({"x", "y"});
  for (Eigen::Index i = 0; i < run.state().position.rows(); ++i) {
    points << run.state().position(i, 0) << run.state().position(i, 1);
  }
  Table bonds({"first", "second"});
  add_bonds(run.lattice(), 0, bonds);
  if (run.wall_lattice() != nullptr) {
    add_bonds(*run.wall_lattice(), run.lattice().points.rows(), bonds);
  }
  points.write(folder / (name + "_points.csv"));
  bonds.write(folder / (name + "_bonds.csv"));
}

}  // namespace

void draw_lattices(const Reproduction& reproduction) {
  Scene pressed;
  pressed.kind = SceneKind::kContact;
  pressed.load.p = 0.01;
  pressed.numerics.integrator = IntegratorKind::kNewton;
  Run contact(pressed);
  contact.advance();
  write_drawing(contact, reproduction.folder, "figure1");

  Scene thrown;
  thrown.wall.kind = WallKind::kLattice;
  thrown.impact.velocity = 0.05;
  Run collision(thrown);
  while (!collision.finished() && collision.disk_state().velocity.col(1).sum() < 0.0) {
    collision.advance();
  }
  write_drawing(collision, reproduction.folder, "figure4");
}

}  // namespace impact
