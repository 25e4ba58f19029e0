#pragma once

#include "lattice/lattice.hpp"

namespace impact {

/// The compression of a disk, §3 of the paper. Lengths in R, angles in rad.
struct Strain {
  double height = 0.0;            ///< R′: of the centre of mass above the lowest point
  double reference_height = 0.0;  ///< R′₀: the same in the unloaded lattice, equally turned
  double rotation = 0.0;          ///< rigid rotation against the reference, counter-clockwise
  double strain() const { return reference_height - height; }  ///< ξ = R′₀ − R′
  double strain_from_radius() const;                           ///< the paper's |R − R′|
};

/// Compares a disk with its reference lattice.
class StrainMeter {
 public:
  explicit StrainMeter(const PointArray& reference);
  Strain measure(const PointArray& position) const;

 private:
  PointArray reference_;  ///< about its centre of mass
};

}  // namespace impact
