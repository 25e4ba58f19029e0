#include "mechanics/potential_wall.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "mechanics/kernels.hpp"

namespace impact {
namespace {

constexpr double kReach = 60.0;  // in units of 1/a

}  // namespace

void PotentialWall::add_forces(const PointArray& position, PointArray& force) {
  constexpr Eigen::Index kAtOnce = 256;
  std::array<std::int32_t, kAtOnce> low{};
  clear();
  const double reach = kReach / a();
  const double* const heights = position.col(1).data();
  for (Eigen::Index first = 0; first < position.rows(); first += kAtOnce) {
    const std::int64_t points = kernels().find_low(
        heights + first, std::min(kAtOnce, position.rows() - first), reach, low.data());
    for (std::int64_t k = 0; k < points; ++k) {
      const Eigen::Index i = first + low[static_cast<std::size_t>(k)];
      const double push = force_at(heights[i]);
      force(i, 1) += push;
      count({0.0, push}, push);
    }
  }
}

double PotentialWall::potential_energy(const PointArray& position) const {
  return potential_at(0.0) * (-a() * position.col(1)).exp().sum();
}

double PotentialWall::height_of_energy(const PointArray& position, double energy) const {
  const double lowest = position.col(1).minCoeff();
  const double sum = (-a() * (position.col(1) - lowest)).exp().sum();
  return std::log(potential_at(0.0) * sum / energy) / a();
}

std::vector<PointForce> PotentialWall::contacts(const PointArray& position,
                                                double least_force) const {
  std::vector<PointForce> contacts;
  const double highest = gap_of_force(least_force);
  for (Eigen::Index i = 0; i < position.rows(); ++i) {
    if (position(i, 1) > highest) continue;
    contacts.push_back({static_cast<std::int32_t>(i), {0.0, force_at(position(i, 1))}});
  }
  return contacts;
}

}  // namespace impact
