#pragma once

#include <vector>

#include "mechanics/contact.hpp"
#include "mechanics/surface_contact.hpp"

namespace impact {

/// Forces on the same points, added up, in the order of the points.
std::vector<PointForce> sum_of(const std::vector<PointForce>& a, const std::vector<PointForce>& b);

/// What two disks do to each other: the points on the outline of each feel the outline of the
/// other, both ways alike, so that neither is the wall. Forces act between a point and its nearest
/// place and along the line between them: momentum and angular momentum stay the same to rounding.
class DiskContact : public Contact {
 public:
  /// A point may be pushed and push as an end of a bond, each by what moves too.
  static constexpr double kMovingEnds = 4.0;

  /// Outlines: rows of each body's convex hull, clockwise, the first of them again at the end.
  DiskContact(const Repulsion& law, double threshold, const std::vector<std::int32_t>& first,
              const std::vector<std::int32_t>& second, const ConstPoints& position);

  void add_forces(const ConstPoints& position, const Points& force);
  void enter(const PointArray& position, EnergyLedger& ledger) const;

  double moving_ends() const override { return kMovingEnds; }
  double threshold() const override { return on_first_.threshold(); }
  double potential_energy(const ConstPoints& position) const override;
  std::vector<PointForce> contacts(const ConstPoints& position, double least_force) const override;
  std::vector<PointForce> reactions(const ConstPoints& position, double least_force) const override;
  void count_hops(const ConstPoints& position) override;
  double hops_size() const override { return on_first_.hops_size() + on_second_.hops_size(); }
  double turned() const override { return on_first_.turned() + on_second_.turned(); }

 private:
  SurfaceContact on_first_;   ///< points of the first body at the outline of the second
  SurfaceContact on_second_;  ///< points of the second body at the outline of the first
};

}  // namespace impact
