#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "output/table.hpp"
#include "reproduction/reproduction.hpp"
#include "run/run.hpp"

namespace impact {
namespace {

/// The bonds of one body with their strains; its points are the rows from `first_row` on.
void add_bonds(const Lattice& lattice, const PointArray& position, Eigen::Index first_row,
               Table& bonds) {
  for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
    const Eigen::Index first = lattice.bonds[k].first + first_row;
    const Eigen::Index second = lattice.bonds[k].second + first_row;
    const double length = std::sqrt((position.row(second) - position.row(first)).square().sum());
    bonds << fmt::format("{}", first) << fmt::format("{}", second)
          << length / lattice.natural_lengths[k] - 1.0;
  }
}

/// Points with the force of the wall on the disk, and bonds.
void write_drawing(Run& run, const std::filesystem::path& folder, const std::string& name) {
  const PointArray& position = run.state().position;
  PointArray force = PointArray::Zero(position.rows(), 2);
  for (const PointForce& contact : run.take_contact_reports().on_first.points) {
    force.row(contact.point) = contact.force.transpose();
  }
  Table points({"x", "y", "fx", "fy"});
  for (Eigen::Index i = 0; i < position.rows(); ++i) {
    points << position(i, 0) << position(i, 1) << force(i, 0) << force(i, 1);
  }
  Table bonds({"first", "second", "strain"});
  add_bonds(run.lattice(), position, 0, bonds);
  for (std::size_t k = 1; k < run.bodies().size(); ++k) {
    add_bonds(run.bodies()[k].lattice, position, run.system().field().body(k).first, bonds);
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
