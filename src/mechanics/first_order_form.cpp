#include "mechanics/first_order_form.hpp"

namespace impact {
namespace {

Eigen::Map<const Eigen::VectorXd> flat(const PointArray& points) {
  return {points.data(), points.size()};
}

}  // namespace

FirstOrderForm::FirstOrderForm(Eigen::Index points)
    : points_(points), position_(points, 2), velocity_(points, 2), force_(points, 2) {}

void FirstOrderForm::pack(const State& state, double* y) const {
  Vector all(y, size());
  all << flat(state.position), flat(state.velocity), 0.0, 0.0;
}

void FirstOrderForm::unpack(const double* y, State& state) const {
  state.position = Eigen::Map<const PointArray>(y, points_, 2);
  state.velocity = Eigen::Map<const PointArray>(y + 2 * points_, points_, 2);
}

bool FirstOrderForm::evaluate(ForceField& field, const double* y, double* rate) {
  position_ = Eigen::Map<const PointArray>(y, points_, 2);
  velocity_ = Eigen::Map<const PointArray>(y + 2 * points_, points_, 2);
  const Losses power = field.evaluate(position_, velocity_, force_);
  Vector all(rate, size());
  all << flat(velocity_), flat(force_) / field.point_mass, power.dissipated, power.absorbed;
  return all.allFinite();
}

void FirstOrderForm::scale(const ForceField& field, double tolerance, const Scales& scales,
                           double* tolerances) const {
  Vector all(tolerances, size());
  all.head(2 * points_).setConstant(tolerance * scales.length);
  all.segment(2 * points_, 2 * points_).setConstant(tolerance * scales.velocity);
  const double mass = static_cast<double>(points_) * field.point_mass;
  all.tail(2).setConstant(tolerance * mass * scales.velocity * scales.velocity);
}

}  // namespace impact
