#include "mechanics/bond_forces.hpp"

#include <cmath>

namespace impact {

BondForces::BondForces(const Lattice& lattice, const BondLaw& law)
    : law_(law),
      begin_(static_cast<std::size_t>(lattice.points.rows()) + 1, 0),
      kernel_(choose_kernel(law.k_b != 0.0, law.eta != 0.0)),
      elastic_kernel_(choose_kernel(law.k_b != 0.0, false)) {
  neighbours_.reserve(lattice.bonds.size());
  for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
    neighbours_.push_back({lattice.bonds[k].second, lattice.natural_lengths[k]});
    ++begin_[static_cast<std::size_t>(lattice.bonds[k].first) + 1];
  }
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
}

BondForces::Kernel BondForces::choose_kernel(bool cubic, bool damped) {
  if (cubic) return damped ? &BondForces::add<true, true> : &BondForces::add<true, false>;
  return damped ? &BondForces::add<false, true> : &BondForces::add<false, false>;
}

template <bool kCubic, bool kDamped>
double BondForces::add(const PointArray& position, const PointArray& velocity,
                       PointArray& force) const {
  const Eigen::Index points = position.rows();
  const double* const x = position.data();
  const double* const y = x + points;
  const double* const vx = velocity.data();
  const double* const vy = vx + points;
  double* const fx = force.data();
  double* const fy = fx + points;
  const double k_a = law_.k_a;
  const double k_b = law_.k_b;
  const double eta = law_.eta;

  double relative_speed_squared = 0.0;
  for (Eigen::Index i = 0; i < points; ++i) {
    double fx_i = 0.0;
    double fy_i = 0.0;
    const std::int32_t end = begin_[static_cast<std::size_t>(i) + 1];
    for (std::int32_t k = begin_[static_cast<std::size_t>(i)]; k < end; ++k) {
      const Neighbour& neighbour = neighbours_[static_cast<std::size_t>(k)];
      const std::int32_t j = neighbour.point;
      const double dx = x[i] - x[j];
      const double dy = y[i] - y[j];
      const double length = std::sqrt(dx * dx + dy * dy);
      const double elongation = length - neighbour.natural_length;
      double stiffness = k_a;
      if constexpr (kCubic) stiffness += k_b * elongation * elongation;
      const double tension_by_length = stiffness * elongation / length;
      double fx_bond = -tension_by_length * dx;
      double fy_bond = -tension_by_length * dy;
      if constexpr (kDamped) {
        const double dvx = vx[i] - vx[j];
        const double dvy = vy[i] - vy[j];
        relative_speed_squared += dvx * dvx + dvy * dvy;
        fx_bond -= eta * dvx;
        fy_bond -= eta * dvy;
      }
      fx_i += fx_bond;
      fy_i += fy_bond;
      fx[j] -= fx_bond;
      fy[j] -= fy_bond;
    }
    fx[i] += fx_i;
    fy[i] += fy_i;
  }
  return eta * relative_speed_squared;
}

double BondForces::potential_energy(const PointArray& position, Eigen::Index first,
                                    Eigen::Index end) const {
  double linear = 0.0;
  double cubic = 0.0;
  for (Eigen::Index i = first; i < end; ++i) {
    const auto place = static_cast<std::size_t>(i);
    for (std::int32_t k = begin_[place]; k < begin_[place + 1]; ++k) {
      const Neighbour& neighbour = neighbours_[static_cast<std::size_t>(k)];
      const double length = (position.row(i) - position.row(neighbour.point)).matrix().norm();
      const double squared = std::pow(length - neighbour.natural_length, 2);
      linear += squared;
      cubic += squared * squared;
    }
  }
  return law_.k_a * linear / 2.0 + law_.k_b * cubic / 4.0;
}

std::vector<Eigen::Triplet<double>> BondForces::stiffness(const PointArray& position) const {
  const auto points = static_cast<std::int32_t>(position.rows());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(16 * neighbours_.size());
  for (std::int32_t i = 0; i < points; ++i) {
    const auto place = static_cast<std::size_t>(i);
    for (std::int32_t k = begin_[place]; k < begin_[place + 1]; ++k) {
      const Neighbour& neighbour = neighbours_[static_cast<std::size_t>(k)];
      const std::int32_t j = neighbour.point;
      const Eigen::Vector2d offset = (position.row(i) - position.row(j)).matrix().transpose();
      const double length = offset.norm();
      const Eigen::Vector2d normal = offset / length;
      const double x = length - neighbour.natural_length;
      const double along = law_.k_a + 3.0 * law_.k_b * x * x;
      const double across = (law_.k_a * x + law_.k_b * x * x * x) / length;
      const Eigen::Matrix2d projection = normal * normal.transpose();
      const Eigen::Matrix2d block =
          along * projection + across * (Eigen::Matrix2d::Identity() - projection);
      for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 2; ++column) {
          const double value = block(row, column);
          entries.emplace_back(row * points + i, column * points + i, value);
          entries.emplace_back(row * points + j, column * points + j, value);
          entries.emplace_back(row * points + i, column * points + j, -value);
          entries.emplace_back(row * points + j, column * points + i, -value);
        }
      }
    }
  }
  return entries;
}

std::vector<Eigen::Triplet<double>> BondForces::damping() const {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * neighbours_.size());
  for (std::size_t place = 0; place + 1 < begin_.size(); ++place) {
    const auto i = static_cast<std::int32_t>(place);
    for (std::int32_t k = begin_[place]; k < begin_[place + 1]; ++k) {
      const std::int32_t j = neighbours_[static_cast<std::size_t>(k)].point;
      entries.emplace_back(i, i, law_.eta);
      entries.emplace_back(j, j, law_.eta);
      entries.emplace_back(i, j, -law_.eta);
      entries.emplace_back(j, i, -law_.eta);
    }
  }
  return entries;
}

std::string BondForces::name() const {
  if (law_.k_b != 0.0) return damped() ? "bonds (cubic, damped)" : "bonds (cubic)";
  return damped() ? "bonds (damped)" : "bonds";
}

}  // namespace impact
