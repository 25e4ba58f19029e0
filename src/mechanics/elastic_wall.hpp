#pragma once

#include <cstdint>
#include <vector>

#include "lattice/lattice.hpp"
#include "mechanics/force_term.hpp"
#include "mechanics/wall_contact.hpp"

namespace impact {

/// How the gap between a point of the disk and the surface bond straight below it is measured.
enum class GapMeasure {
  /// Perpendicular to the bond, as in fig. 5 of the paper. The reaction on the bond's ends balances
  /// force and torque. Where a point passes from one bond to the next the gap jumps, and the energy
  /// with it.
  kNormal,
  /// Along y. The gap is continuous, and energy is conserved from bond to bond. The force still
  /// points along the bond's normal, so that where the surface has the slope s the pair feels a
  /// torque of s times gap times force.
  kVertical
};

/// The contact of the disk with the surface of an elastic wall, §5 of the paper. The wall's top
/// side is a chain of bonds. A point of the disk whose gap l to the bond straight below it is less
/// than a threshold feels a V₀ exp(−a l) n with the bond's normal n; the two ends of the bond take
/// the reaction, split by the lever rule at the foot of the point on the bond's line. While the
/// bond stays the same these are the exact derivatives of V₀ exp(−a l).
///
/// The bond below each point is followed from evaluation to evaluation by walking along the chain,
/// O(1) a point as long as points pass a few bonds at most in one step.
class ElasticWall : public ForceTerm, public WallContact {
 public:
  static constexpr const char* kName = "elastic wall";
  static constexpr bool kInLanes = true;

  /// The rows 0 … disk_points − 1 of all arrays are the disk's; `surface` holds the rows of the
  /// wall's top side in the order of x. `threshold` in R.
  ElasticWall(const WallContact& law, double threshold, GapMeasure measure,
              Eigen::Index disk_points, std::vector<std::int32_t> surface,
              const ConstPoints& position);

  void add_forces(const ConstPoints& position, Points force);

  /// Compares the bonds below the points with those at the count before. To be called where a step
  /// of the motion is done, at the position of the last evaluation: those between, of the stages of
  /// an integrator, do not count.
  void count_hops(const ConstPoints& position);

  /// Gap (R) from which on nothing is felt.
  double threshold() const { return threshold_; }

  /// With the bond below each point as in the last evaluation.
  double potential_energy(const ConstPoints& position) const;
  void enter(const PointArray& position, EnergyLedger& ledger) const {
    ledger.wall += potential_energy(position);
    ledger.hops -= hops_;
    ledger.hops_size += hops_size_;
  }

  /// What the points of the disk beside the wall would hold if its surface went on level from its
  /// ends (M c²).
  double energy_beside(const ConstPoints& position) const;

  /// Energy that appeared because a point in reach came to another bond, or in or out of reach,
  /// from count to count so far (M c²): the sum of its changes, and of their sizes.
  double hops() const { return hops_; }
  double hops_size() const { return hops_size_; }

  /// Energy of contacts that passed to another bond, times the size of the change of the normal,
  /// from count to count so far (M c²): forces that turned by a jump, even where no energy hops.
  double turned() const { return turned_; }

  /// The points of the disk that the wall pushes with more than `least_force` (M c²/R).
  std::vector<PointForce> contacts(const ConstPoints& position, double least_force) const;
  /// The reactions to those forces, by point of the wall.
  std::vector<PointForce> reactions(const ConstPoints& position, double least_force) const;

 private:
  static constexpr std::int32_t kNone = -1;

  /// A point above a bond of the surface.
  struct Gap {
    double length;          ///< R
    Eigen::Array2d normal;  ///< gradient of the length with respect to the point
    double foot;            ///< place on the bond, 0 at its first end, 1 at its second
  };

  template <GapMeasure kMeasure>
  Gap gap(const ConstPoints& position, Eigen::Index point, std::int32_t bond) const;
  Gap gap(const ConstPoints& position, Eigen::Index point, std::int32_t bond) const;
  template <GapMeasure kMeasure>
  void add(const ConstPoints& position, Points& force);
  template <class Use>
  void for_each_contact(const ConstPoints& position, const Use& use) const;
  /// The bond straight below a place; kNone beside the wall.
  std::int32_t bond_below(const ConstPoints& position, double x, std::int32_t guess) const;
  double highest_in_reach(const ConstPoints& position) const;
  double potential_of(const ConstPoints& position, Eigen::Index point, std::int32_t bond) const;

  double threshold_;
  GapMeasure measure_;
  Eigen::Index disk_points_;
  std::vector<std::int32_t> surface_;
  std::vector<std::int32_t> bond_;          ///< below each point of the disk; kNone: out of reach
  std::vector<std::int32_t> counted_bond_;  ///< the same at the last count
  double hops_ = 0.0;
  double hops_size_ = 0.0;
  double turned_ = 0.0;
};

}  // namespace impact
