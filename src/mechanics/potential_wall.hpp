#pragma once

#include <vector>

#include "kernels/in_parts.hpp"
#include "lattice/lattice.hpp"
#include "mechanics/contact.hpp"
#include "mechanics/force_term.hpp"

namespace impact {

/// The repulsive wall at y = 0 of eqs. (3) and (6): potential V₀ exp(−a y) and force
/// a V₀ exp(−a y) ŷ on every point. Where a y exceeds 60 a point feels nothing: the potential
/// there is below 10⁻²⁶ V₀.
class PotentialWall : public ForceTerm, public Contact {
 public:
  static constexpr const char* kName = "potential wall";
  static constexpr bool kInLanes = true;

  using Contact::Contact;

  void add_forces(const PointArray& position, PointArray& force);

  // The same part by part: of each part of the points, and then of all together.
  void begin_parts(Eigen::Index points);
  void add_forces_of_part(Eigen::Index part, const PointRows& rows, const PointArray& position,
                          PointArray& force);
  void sum_up();

  WallLaw law() const;

  void add_stiffness(const PointArray& position, MatrixEntries& entries) const;
  static bool shifts_freely(int axis) { return axis == 0; }
  double potential_energy(const ConstPoints& position) const override;
  void enter(const PointArray& position, EnergyLedger& ledger) const {
    ledger.wall += potential_energy(position);
  }

  /// Height of the lowest point, everything moved up or down rigidly, at which the potential
  /// energy of these points is `energy` (M c²).
  double height_of_energy(const PointArray& position, double energy) const;

  /// The points that the wall pushes with more than `least_force` (M c²/R).
  std::vector<PointForce> contacts(const ConstPoints& position, double least_force) const override;

 private:
  std::vector<WallForce> parts_{WallForce{}};  ///< of the last evaluation, by parts of the points
};

}  // namespace impact
