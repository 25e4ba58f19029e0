#include "mechanics/potential_wall.hpp"

#include <algorithm>
#include <cmath>

namespace impact {
namespace {

constexpr double kReach = 60.0;  // in units of 1/a

}  // namespace

void PotentialWall::add_forces(const PointArray& position, PointArray& force) {
  total_force_ = 0.0;
  largest_force_ = 0.0;
  const double reach = kReach / a_;
  for (Eigen::Index i = 0; i < position.rows(); ++i) {
    const double height = position(i, 1);
    if (height > reach) continue;
    const double push = force_at(height);
    force(i, 1) += push;
    total_force_ += push;
    largest_force_ = std::max(largest_force_, push);
  }
}

double PotentialWall::force_at(double height) const { return a_ * v0_ * std::exp(-a_ * height); }

double PotentialWall::height_of_force(double force) const {
  return std::log(a_ * v0_ / force) / a_;
}

double PotentialWall::potential_energy(const PointArray& position) const {
  return v0_ * (-a_ * position.col(1)).exp().sum();
}

double PotentialWall::height_of_energy(const PointArray& position, double energy) const {
  const double lowest = position.col(1).minCoeff();
  const double sum = (-a_ * (position.col(1) - lowest)).exp().sum();
  return std::log(v0_ * sum / energy) / a_;
}

}  // namespace impact
