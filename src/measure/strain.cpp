#include "measure/strain.hpp"

#include <cmath>

#include "mechanics/body_motion.hpp"

namespace impact {

double Strain::strain_from_radius() const { return std::abs(1.0 - height); }

StrainMeter::StrainMeter(const PointArray& reference)
    : reference_(reference.rowwise() - reference.colwise().mean()) {}

Strain StrainMeter::measure(const PointArray& position) const {
  Strain strain;
  strain.rotation = rigid_rotation(reference_, position);
  strain.height = position.col(1).mean() - position.col(1).minCoeff();
  const auto turned_y =
      std::sin(strain.rotation) * reference_.col(0) + std::cos(strain.rotation) * reference_.col(1);
  strain.reference_height = -turned_y.minCoeff();
  return strain;
}

}  // namespace impact
