#include "mechanics/elastic_wall.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace impact {

ElasticWall::ElasticWall(const WallContact& law, double threshold, GapMeasure measure,
                         Eigen::Index disk_points, std::vector<std::int32_t> surface,
                         const ConstPoints& position)
    : WallContact(law),
      threshold_(threshold),
      measure_(measure),
      disk_points_(disk_points),
      surface_(std::move(surface)),
      bond_(static_cast<std::size_t>(disk_points), kNone) {
  PointArray unused = PointArray::Zero(position.rows(), 2);
  add_forces(position, unused);
  counted_bond_ = bond_;
}

void ElasticWall::add_forces(const ConstPoints& position, Points force) {
  if (measure_ == GapMeasure::kNormal) {
    add<GapMeasure::kNormal>(position, force);
  } else {
    add<GapMeasure::kVertical>(position, force);
  }
}

template <GapMeasure kMeasure>
ElasticWall::Gap ElasticWall::gap(const ConstPoints& position, Eigen::Index point,
                                  std::int32_t bond) const {
  const std::int32_t first = surface_[static_cast<std::size_t>(bond)];
  const std::int32_t second = surface_[static_cast<std::size_t>(bond) + 1];
  const double dx = position(second, 0) - position(first, 0);
  const double dy = position(second, 1) - position(first, 1);
  const double x = position(point, 0) - position(first, 0);
  const double y = position(point, 1) - position(first, 1);
  if constexpr (kMeasure == GapMeasure::kNormal) {
    const double length = std::hypot(dx, dy);
    return {(dx * y - dy * x) / length,
            {-dy / length, dx / length},
            (dx * x + dy * y) / (length * length)};
  } else {
    return {y - dy / dx * x, {-dy / dx, 1.0}, x / dx};
  }
}

ElasticWall::Gap ElasticWall::gap(const ConstPoints& position, Eigen::Index point,
                                  std::int32_t bond) const {
  return measure_ == GapMeasure::kNormal ? gap<GapMeasure::kNormal>(position, point, bond)
                                         : gap<GapMeasure::kVertical>(position, point, bond);
}

template <GapMeasure kMeasure>
void ElasticWall::add(const ConstPoints& position, Points& force) {
  clear();
  const double highest = highest_in_reach(position);
  for (Eigen::Index i = 0; i < disk_points_; ++i) {
    std::int32_t& bond = bond_[static_cast<std::size_t>(i)];
    bond = position(i, 1) > highest ? kNone : bond_below(position, position(i, 0), bond);
    if (bond == kNone) continue;
    const Gap gap_now = gap<kMeasure>(position, i, bond);
    if (gap_now.length >= threshold_) {
      bond = kNone;
      continue;
    }

    const double size = force_at(gap_now.length);
    const Eigen::Array2d push = size * gap_now.normal;
    const std::int32_t first = surface_[static_cast<std::size_t>(bond)];
    const std::int32_t second = surface_[static_cast<std::size_t>(bond) + 1];
    for (int axis = 0; axis < 2; ++axis) {
      const double reaction = gap_now.foot * push(axis);
      force(i, axis) += push(axis);
      force(first, axis) -= push(axis) - reaction;
      force(second, axis) -= reaction;
    }
    count(push, size);
  }
}

double ElasticWall::highest_in_reach(const ConstPoints& position) const {
  // A gap measured perpendicular to a bond is at least half the vertical one on slopes up to √3.
  constexpr double kSteepest = 2.0;
  double top = position(surface_.front(), 1);
  for (const std::int32_t point : surface_) top = std::max(top, position(point, 1));
  return top + kSteepest * threshold_;
}

std::int32_t ElasticWall::bond_below(const ConstPoints& position, double x,
                                     std::int32_t guess) const {
  const auto x_of = [&](std::int32_t k) {
    return position(surface_[static_cast<std::size_t>(k)], 0);
  };
  const auto bonds = static_cast<std::int32_t>(surface_.size()) - 1;
  const double left = x_of(0);
  const double right = x_of(bonds);
  if (!(x >= left && x < right)) return kNone;  // nor for NaN
  std::int32_t k = guess;
  if (k == kNone) {
    const auto evenly = static_cast<std::int32_t>((x - left) / (right - left) * bonds);
    k = std::clamp(evenly, 0, bonds - 1);
  }
  while (k > 0 && x < x_of(k)) --k;
  while (k + 1 < bonds && x >= x_of(k + 1)) ++k;
  return k;
}

void ElasticWall::count_hops(const ConstPoints& position) {
  for (std::size_t i = 0; i < bond_.size(); ++i) {
    if (bond_[i] == counted_bond_[i]) continue;
    const auto point = static_cast<Eigen::Index>(i);
    const double change =
        potential_of(position, point, bond_[i]) - potential_of(position, point, counted_bond_[i]);
    hops_ += change;
    hops_size_ += std::abs(change);
    if (bond_[i] == kNone || counted_bond_[i] == kNone) continue;
    const Gap now = gap(position, point, bond_[i]);
    const Gap before = gap(position, point, counted_bond_[i]);
    turned_ += potential_at(now.length) * (now.normal - before.normal).matrix().norm();
  }
  counted_bond_ = bond_;
}

double ElasticWall::potential_of(const ConstPoints& position, Eigen::Index point,
                                 std::int32_t bond) const {
  return bond == kNone ? 0.0 : potential_at(gap(position, point, bond).length);
}

double ElasticWall::potential_energy(const ConstPoints& position) const {
  double energy = 0.0;
  for (Eigen::Index i = 0; i < disk_points_; ++i) {
    energy += potential_of(position, i, bond_[static_cast<std::size_t>(i)]);
  }
  return energy;
}

double ElasticWall::energy_beside(const ConstPoints& position) const {
  const auto left = position.row(surface_.front());
  const auto right = position.row(surface_.back());
  double energy = 0.0;
  for (Eigen::Index i = 0; i < disk_points_; ++i) {
    if (position(i, 0) < left.x()) energy += potential_at(position(i, 1) - left.y());
    if (position(i, 0) > right.x()) energy += potential_at(position(i, 1) - right.y());
  }
  return energy;
}

template <class Use>
void ElasticWall::for_each_contact(const ConstPoints& position, const Use& use) const {
  for (Eigen::Index i = 0; i < disk_points_; ++i) {
    const std::int32_t bond = bond_[static_cast<std::size_t>(i)];
    if (bond == kNone) continue;
    const Gap contact = gap(position, i, bond);
    use(static_cast<std::int32_t>(i), bond, contact, force_at(contact.length));
  }
}

std::vector<PointForce> ElasticWall::contacts(const ConstPoints& position,
                                              double least_force) const {
  std::vector<PointForce> contacts;
  for_each_contact(position, [&](std::int32_t point, std::int32_t, const Gap& gap, double size) {
    if (size > least_force) contacts.push_back({point, size * gap.normal});
  });
  return contacts;
}

std::vector<PointForce> ElasticWall::reactions(const ConstPoints& position,
                                               double least_force) const {
  std::vector<PointForce> on_surface;
  for (const std::int32_t point : surface_) {
    on_surface.push_back({point - static_cast<std::int32_t>(disk_points_), Eigen::Array2d::Zero()});
  }
  for_each_contact(position, [&](std::int32_t, std::int32_t bond, const Gap& gap, double size) {
    if (size <= least_force) return;
    const auto place = static_cast<std::size_t>(bond);
    on_surface[place].force -= (1.0 - gap.foot) * size * gap.normal;
    on_surface[place + 1].force -= gap.foot * size * gap.normal;
  });
  on_surface.erase(std::remove_if(on_surface.begin(), on_surface.end(),
                                  [](const PointForce& p) { return (p.force == 0.0).all(); }),
                   on_surface.end());
  return on_surface;
}

}  // namespace impact
