#include "mechanics/potential_wall.hpp"

#include <algorithm>
#include <cmath>

namespace impact {
namespace {

constexpr double kReach = 60.0;  // in units of 1/a

}  // namespace

void PotentialWall::add_forces(const PointArray& position, PointArray& force) {
  begin_parts(position.rows());
  in_parts(position.rows(), [&](Eigen::Index part, Eigen::Index first, Eigen::Index size) {
    add_forces_of_part(part, {first, size}, position, force);
  });
  sum_up();
}

void PotentialWall::begin_parts(Eigen::Index points) {
  parts_.resize(static_cast<std::size_t>(parts_of(points)));
}

void PotentialWall::add_forces_of_part(Eigen::Index part, const PointRows& rows,
                                       const PointArray& position, PointArray& force) {
  parts_[static_cast<std::size_t>(part)] =
      kernels().potential_wall(law(), &position(rows.first, 1), rows.size, &force(rows.first, 1));
}

void PotentialWall::sum_up() {
  WallForce all{0.0, 0.0};
  for (const WallForce& part : parts_) {
    all.total += part.total;
    all.largest = std::max(all.largest, part.largest);
  }
  take_in({0.0, all.total}, all.largest);
}

void PotentialWall::add_stiffness(const PointArray& position, MatrixEntries& entries) const {
  const auto points = static_cast<std::int32_t>(position.rows());
  for (std::int32_t i = 0; i < points; ++i) {
    entries.emplace_back(points + i, points + i, stiffness(force_at(position(i, 1))));
  }
}

WallLaw PotentialWall::law() const { return {a(), force_at(0.0), kReach / a()}; }

double PotentialWall::potential_energy(const ConstPoints& position) const {
  const double reach = law().reach;
  double energy = 0.0;
  for (const double height : position.col(1)) {
    if (!(height > reach)) energy += potential_at(height);
  }
  return energy;
}

double PotentialWall::height_of_energy(const PointArray& position, double energy) const {
  const double lowest = position.col(1).minCoeff();
  const double reach = law().reach;
  double sum = 0.0;
  for (const double height : position.col(1)) {
    if (height - lowest < reach) sum += std::exp(-a() * (height - lowest));
  }
  return std::log(potential_at(0.0) * sum / energy) / a();
}

std::vector<PointForce> PotentialWall::contacts(const ConstPoints& position,
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
