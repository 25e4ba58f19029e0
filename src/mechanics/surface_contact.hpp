#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "lattice/lattice.hpp"
#include "mechanics/contact.hpp"
#include "mechanics/contact_names.hpp"
#include "mechanics/force_term.hpp"

namespace impact {

/// How the gap between a point of one body and the surface of another is measured.
enum class GapMeasure {
  /// Perpendicular to the bond straight below, as in fig. 5 of the paper. The reaction on the
  /// bond's
  /// ends balances force and torque. Where a point passes from one bond to the next the gap jumps,
  /// and the energy with it.
  kNormal,
  /// Along y. The gap is continuous, and energy is conserved from bond to bond. The force still
  /// points along the bond's normal, so that where the surface has the slope s the pair feels a
  /// torque of s times gap times force.
  kVertical,
  /// To the nearest place of a closed outline, negative inside it. The gap is continuous, so that
  /// energy hops at the threshold alone, and its gradient turns by a jump only in dents of the
  /// outline; force and torque balance. It knows no direction. A point that lies in a dent passes
  /// to
  /// and fro between the same two bonds; as long as it does, turned() counts it once.
  kNearest
};

/// What the points of one body feel above the surface of another, a chain of bonds as in §5 of the
/// paper. A point whose gap l is less than a threshold feels a V₀ exp(−a l) n with the gradient n
/// of the gap; the two ends of the bond take the reaction, split by the lever rule at the foot of
/// the point on the bond's line, or at the end that is nearest. While the bond stays the same these
/// are the exact derivatives of V₀ exp(−a l).
///
/// The bond of each point is followed from evaluation to evaluation by walking along the chain,
/// O(1) a point as long as points pass a few bonds at most in one step.
class SurfaceContact : public ForceTerm, public Contact {
 public:
  static constexpr const char* kName = kElasticWallName;
  static constexpr bool kInLanes = true;
  static constexpr double kMovingEnds = 2.0;

  /// `points`: rows of those that may touch. `surface`: rows of the chain's points, the body on its
  /// right hand: for kNormal and kVertical of a top side, in the order of x; for kNearest a closed
  /// one, whose last point is its first. `threshold` in R.
  SurfaceContact(const Repulsion& law, double threshold, GapMeasure measure,
                 std::vector<std::int32_t> points, std::vector<std::int32_t> surface,
                 const ConstPoints& position);

  void add_forces(const ConstPoints& position, Points force);
  void count_hops(const ConstPoints& position) override;
  double moving_ends() const override { return kMovingEnds; }
  double threshold() const override { return threshold_; }

  /// With the bond of each point as in the last evaluation.
  double potential_energy(const ConstPoints& position) const override;
  void enter(const PointArray& position, EnergyLedger& ledger) const {
    ledger.wall += potential_energy(position);
    ledger.hops -= hops_;
    ledger.hops_size += hops_size_;
  }

  double energy_beside(const ConstPoints& position) const override;
  /// Energy that appeared because a point in reach came to another bond, or in or out of reach,
  /// from count to count so far (M c²).
  double hops() const { return hops_; }
  double hops_size() const override { return hops_size_; }
  double turned() const override { return turned_; }
  std::vector<PointForce> contacts(const ConstPoints& position, double least_force) const override;
  std::vector<PointForce> reactions(const ConstPoints& position, double least_force) const override;

 private:
  static constexpr std::int32_t kNone = -1;

  /// A point above a bond of the surface.
  struct Gap {
    double length;          ///< R
    Eigen::Array2d normal;  ///< gradient of the length with respect to the point
    double foot;            ///< place on the bond, 0 at its first end, 1 at its second
  };
  /// What is farther away from the outline than the threshold lies outside this circle.
  struct Circle {
    Eigen::Array2d centre;
    double radius;
    bool is_beyond(double x, double y) const {
      return !(std::pow(x - centre.x(), 2) + std::pow(y - centre.y(), 2) <= radius * radius);
    }
  };

  /// A bond, and a point as seen from its first end, R.
  struct Place {
    double dx, dy;
    double x, y;
  };

  Place place_at(const ConstPoints& position, Eigen::Index point, std::int32_t bond) const;
  template <GapMeasure kMeasure>
  Gap gap(const ConstPoints& position, Eigen::Index point, std::int32_t bond) const;
  Gap gap(const ConstPoints& position, Eigen::Index point, std::int32_t bond) const;
  Gap gap_to_corner(const ConstPoints& position, std::int32_t corner, double x, double y,
                    double foot) const;
  template <GapMeasure kMeasure>
  void add(const ConstPoints& position, Points& force);
  template <class Use>
  void for_each_contact(const ConstPoints& position, const Use& use) const;
  /// The bond straight below a place; kNone beside the wall.
  std::int32_t bond_below(const ConstPoints& position, double x, std::int32_t guess) const;
  template <GapMeasure kMeasure>
  auto reach_of(const ConstPoints& position) const;
  double highest_in_reach(const ConstPoints& position) const;
  std::int32_t nearest_bond(const ConstPoints& position, Eigen::Index point,
                            std::int32_t guess) const;
  /// Where a walk to the nearest bond may start: the bonds taken as even in the angle.
  std::int32_t bond_in_direction(const ConstPoints& position, Eigen::Index point) const;
  double squared_distance(const ConstPoints& position, Eigen::Index point, std::int32_t bond) const;
  Eigen::Array2d centre_of_surface(const ConstPoints& position) const;
  Circle circle_in_reach(const ConstPoints& position) const;
  void count_hop(const ConstPoints& position, std::size_t i);
  double potential_of(const ConstPoints& position, Eigen::Index point, std::int32_t bond) const;
  std::int32_t bonds() const { return static_cast<std::int32_t>(surface_.size()) - 1; }

  double threshold_;
  GapMeasure measure_;
  std::vector<std::int32_t> points_;
  std::vector<std::int32_t> surface_;
  std::vector<std::int32_t> bond_;          ///< of each point; kNone: out of reach
  std::vector<std::int32_t> counted_bond_;  ///< the same at the last count
  std::vector<std::int32_t> left_bond_;     ///< the last one that was another than that
  double hops_ = 0.0;
  double hops_size_ = 0.0;
  double turned_ = 0.0;
};

}  // namespace impact
