#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "mechanics/body.hpp"
#include "mechanics/bond_forces.hpp"
#include "mechanics/centrifugal_force.hpp"
#include "mechanics/compression_load.hpp"
#include "mechanics/contact.hpp"
#include "mechanics/disk_contacts.hpp"
#include "mechanics/energy_ledger.hpp"
#include "mechanics/force_term.hpp"
#include "mechanics/gravity.hpp"
#include "mechanics/losses.hpp"
#include "mechanics/potential_wall.hpp"
#include "mechanics/rotation_hold.hpp"
#include "mechanics/state.hpp"
#include "mechanics/supports.hpp"
#include "mechanics/surface_contact.hpp"
#include "mechanics/velocity_reset.hpp"
#include "mechanics/viscous_boundary.hpp"

namespace impact {

class VelocitySolver;

/// All that acts on the points of one scene: its bonds and, only if the scene has them, a wall, a
/// load, constraints and a boundary. All arrays have one row a point, body by body.
struct ForceField {
  /// By which integrators know what they move.
  using Number = double;
  using Step = double;
  using Points = PointArray;
  using State = impact::State;
  using Losses = impact::Losses;
  using VelocitySolver = impact::VelocitySolver;

  BondForces bonds;
  double point_mass = 1.0;     ///< M
  std::vector<Body> others{};  ///< what the first body meets, after it in all arrays
  /// Of all points, where no bond is strained; only for methods that take bonds implicitly.
  std::shared_ptr<const PointArray> unstrained{};
  std::optional<PotentialWall> wall{};
  std::optional<SurfaceContact> elastic_wall{};
  std::optional<DiskContacts> disk_contacts{};
  std::optional<CompressionLoad> load{};
  std::optional<Gravity> gravity{};
  std::optional<CentrifugalForce> centrifugal{};
  std::optional<ViscousBoundary> viscous_boundary{};
  std::optional<VelocityReset> velocity_reset{};
  std::optional<RotationHold> hold{};
  std::optional<Supports> supports{};

  /// All terms but the bonds, in the order in which their forces are added.
  template <class Field>
  static auto every_term(Field& field) {
    return std::tie(field.wall, field.elastic_wall, field.disk_contacts, field.load, field.gravity,
                    field.centrifugal, field.viscous_boundary, field.velocity_reset, field.hold,
                    field.supports);
  }
  /// Calls use(term) for each term that the scene has.
  template <class Use>
  void for_each_term(const Use& use) {
    visit(*this, use);
  }
  template <class Use>
  void for_each_term(const Use& use) const {
    visit(*this, use);
  }

  std::uint64_t evaluations = 0;  ///< of the forces, so far

  /// Overwrites `force` (M c²/R, one row a point) with the total force on each point. Returns the
  /// powers lost.
  Losses evaluate(const PointArray& position, const PointArray& velocity, PointArray& force);

  /// The same without damping: the force on points at rest.
  void evaluate_undamped(const PointArray& position, PointArray& force);

  /// The same in one pass through the points where the field allows it: place(rows) is called for
  /// rows of points before their positions, which it may change, are read and their forces are
  /// overwritten, and use(rows) once their forces are there; on several threads at a time.
  template <class Place, class Use>
  void evaluate_undamped(const PointArray& position, PointArray& force, const Place& place,
                         const Use& use) {
    if (!has_local_terms()) {
      const auto all = [&](const auto& work) {
        in_parts(position.rows(),
                 [&](Eigen::Index /*part*/, Eigen::Index first, Eigen::Index size) {
                   work(PointRows{first, size});
                 });
      };
      all(place);
      evaluate_undamped(position, force);
      all(use);
      return;
    }
    ++evaluations;
    if (wall) wall->begin_parts(position.rows());
    bonds.evaluate_elastic(position, force, place, [&](Eigen::Index part, const PointRows& rows) {
      if (wall) wall->add_forces_of_part(part, rows, position, force);
      use(rows);
    });
    if (wall) wall->sum_up();
  }

  /// The damping forces alone, −D v, overwritten. Returns the powers lost.
  Losses evaluate_damping(const PointArray& velocity, PointArray& force);

  /// The entries of the matrix D of the damping forces −D v along one axis (0: x, 1: y), in M c/R:
  /// those of the bonds and of a viscous boundary, those of one place to be added up. Rows and
  /// columns of supported coordinates are empty.
  MatrixEntries damping(int axis) const;

  /// The entries of the tangent stiffness matrix −∂F/∂r (M c²/R²) of the bonds and of a potential
  /// wall, those of one place to be added up; row and column i stand for x of point i, N + i for
  /// its y. A supported coordinate has a diagonal element only.
  MatrixEntries stiffness(const PointArray& position) const;
  /// The same in place of the entries given, whose memory is used again.
  void find_stiffness(const PointArray& position, MatrixEntries& entries) const;

  /// Of bonds, wall and load, in M c².
  double potential_energy(const PointArray& position) const;
  double wall_potential_energy(const PointArray& position) const;
  /// Where the energy is, after these losses.
  EnergyLedger ledger(const impact::State& state, const impact::Losses& losses) const;

  /// Whether forces depend on velocities.
  bool damped() const;

  /// Whether a rigid shift along this axis (0: x, 1: y) costs no energy, so that forces are the
  /// same after it.
  bool shifts_freely(int axis) const;

  /// The disk that the scene is about.
  Body first_body() const { return {0, bonds.points() - other_points(), true}; }
  /// Of all other bodies.
  Eigen::Index other_points() const {
    return others.empty() ? 0 : bonds.points() - others.front().first;
  }
  std::size_t number_of_bodies() const { return 1 + others.size(); }
  /// By its number: 0 is the first.
  Body body(std::size_t number) const { return number == 0 ? first_body() : others[number - 1]; }
  /// In M; that of the first body is 1 M.
  double mass_of(const Body& body) const {
    return static_cast<double>(body.points) / static_cast<double>(first_body().points);
  }
  /// Of the first body and all others that are free, in M: of the first alone at a wall.
  double reduced_mass() const;
  /// Of the motion of the centres of mass against each other along one direction, where the first
  /// moves at this velocity (c) as seen from the centre of mass of all that is free, in M c².
  double impact_energy(double velocity) const { return 0.5 * velocity * velocity / reduced_mass(); }
  double kinetic_energy(const Body& body, const impact::State& state) const;  ///< M c²
  double bond_energy(const Body& body, const impact::State& state) const;     ///< M c²

  void resize(PointArray& all_points) const { all_points.resize(bonds.points(), 2); }

  /// The power that a viscous boundary would absorb at these velocities (M c³/R).
  double boundary_power(const PointArray& velocity) const {
    return viscous_boundary ? viscous_boundary->power(velocity) : 0.0;
  }

  /// What the first body meets; none: nullptr.
  const Contact* contact() const;

  /// See Contact::count_hops().
  void count_hops(const ConstPoints& position) {
    if (elastic_wall) elastic_wall->count_hops(position);
    if (disk_contacts) disk_contacts->count_hops(position);
  }

  /// Names of the terms that are evaluated.
  std::vector<std::string> terms() const;

 private:
  /// Whether no force on a point depends on others than those that it has bonds with.
  bool has_local_terms() const;
  void add_damping_of_terms(const PointArray& velocity, PointArray& force, Losses& power) const;
  void enter_free(const Body& body, const impact::State& state, EnergyLedger& ledger) const;

  template <class Field, class Use>
  static void visit(Field& field, const Use& use) {
    const auto visit_one = [&](auto& term) {
      if (term) use(*term);
    };
    std::apply([&](auto&... terms) { (visit_one(terms), ...); }, every_term(field));
  }
};

}  // namespace impact
