#include "mechanics/surface_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace impact {

SurfaceContact::SurfaceContact(const Repulsion& law, double threshold, GapMeasure measure,
                               std::vector<std::int32_t> points, std::vector<std::int32_t> surface,
                               const ConstPoints& position)
    : Contact(law),
      threshold_(threshold),
      measure_(measure),
      points_(std::move(points)),
      surface_(std::move(surface)),
      bond_(points_.size(), kNone),
      left_bond_(points_.size(), kNone) {
  PointArray unused = PointArray::Zero(position.rows(), 2);
  add_forces(position, unused);
  counted_bond_ = bond_;
}

SurfaceContact::Circle SurfaceContact::circle_in_reach(const ConstPoints& position) const {
  const Eigen::Array2d centre = centre_of_surface(position);
  double outermost = 0.0;
  for (const std::int32_t point : surface_) {
    outermost = std::max(
        outermost, std::hypot(position(point, 0) - centre.x(), position(point, 1) - centre.y()));
  }
  return {centre, outermost + threshold_};
}

double SurfaceContact::highest_in_reach(const ConstPoints& position) const {
  // A gap measured perpendicular to a bond is at least half the vertical one on slopes up to √3.
  constexpr double kSteepest = 2.0;
  double top = position(surface_.front(), 1);
  for (const std::int32_t point : surface_) top = std::max(top, position(point, 1));
  return top + kSteepest * threshold_;
}

template <GapMeasure kMeasure>
auto SurfaceContact::reach_of(const ConstPoints& position) const {
  if constexpr (kMeasure == GapMeasure::kNearest) {
    return circle_in_reach(position);
  } else {
    return highest_in_reach(position);
  }
}

void SurfaceContact::add_forces(const ConstPoints& position, Points force) {
  switch (measure_) {
    case GapMeasure::kNormal:
      return add<GapMeasure::kNormal>(position, force);
    case GapMeasure::kVertical:
      return add<GapMeasure::kVertical>(position, force);
    case GapMeasure::kNearest:
      return add<GapMeasure::kNearest>(position, force);
  }
}

/// Of a point that is nearest to the end `corner` of a bond (0: the first of the chain), from which
/// it lies at x, y. Nearest to a corner that sticks out is only what lies outside, nearest to one
/// in a dent only what lies inside.
SurfaceContact::Gap SurfaceContact::gap_to_corner(const ConstPoints& position, std::int32_t corner,
                                                  double x, double y, double foot) const {
  const auto place = [&](std::int32_t k) -> Eigen::Array2d {
    return position.row(surface_[static_cast<std::size_t>((k + bonds()) % bonds())]).transpose();
  };
  const Eigen::Array2d before = place(corner) - place(corner - 1);
  const Eigen::Array2d after = place(corner + 1) - place(corner);
  const bool sticks_out = before.x() * after.y() - before.y() * after.x() <= 0.0;  // clockwise
  const double side = sticks_out ? 1.0 : -1.0;
  const double distance = std::hypot(x, y);
  return {side * distance, {side * x / distance, side * y / distance}, foot};
}

SurfaceContact::Place SurfaceContact::place_at(const ConstPoints& position, Eigen::Index point,
                                               std::int32_t bond) const {
  const std::int32_t first = surface_[static_cast<std::size_t>(bond)];
  const std::int32_t second = surface_[static_cast<std::size_t>(bond) + 1];
  return {position(second, 0) - position(first, 0), position(second, 1) - position(first, 1),
          position(point, 0) - position(first, 0), position(point, 1) - position(first, 1)};
}

template <GapMeasure kMeasure>
SurfaceContact::Gap SurfaceContact::gap(const ConstPoints& position, Eigen::Index point,
                                        std::int32_t bond) const {
  const auto [dx, dy, x, y] = place_at(position, point, bond);
  if constexpr (kMeasure == GapMeasure::kVertical) {
    return {y - dy / dx * x, {-dy / dx, 1.0}, x / dx};
  }
  const double length = std::hypot(dx, dy);
  Gap across{(dx * y - dy * x) / length,
             {-dy / length, dx / length},
             (dx * x + dy * y) / (length * length)};
  if constexpr (kMeasure == GapMeasure::kNearest) {
    if (across.foot < 0.0) return gap_to_corner(position, bond, x, y, 0.0);
    if (across.foot > 1.0) return gap_to_corner(position, bond + 1, x - dx, y - dy, 1.0);
  }
  return across;
}

SurfaceContact::Gap SurfaceContact::gap(const ConstPoints& position, Eigen::Index point,
                                        std::int32_t bond) const {
  switch (measure_) {
    case GapMeasure::kNormal:
      return gap<GapMeasure::kNormal>(position, point, bond);
    case GapMeasure::kVertical:
      return gap<GapMeasure::kVertical>(position, point, bond);
    case GapMeasure::kNearest:
      break;
  }
  return gap<GapMeasure::kNearest>(position, point, bond);
}

template <GapMeasure kMeasure>
void SurfaceContact::add(const ConstPoints& position, Points& force) {
  clear();
  const auto reach = reach_of<kMeasure>(position);
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const Eigen::Index i = points_[k];
    std::int32_t& bond = bond_[k];
    if constexpr (kMeasure == GapMeasure::kNearest) {
      bond =
          reach.is_beyond(position(i, 0), position(i, 1)) ? kNone : nearest_bond(position, i, bond);
    } else {
      bond = position(i, 1) > reach ? kNone : bond_below(position, position(i, 0), bond);
    }
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

std::int32_t SurfaceContact::bond_below(const ConstPoints& position, double x,
                                        std::int32_t guess) const {
  const auto x_of = [&](std::int32_t k) {
    return position(surface_[static_cast<std::size_t>(k)], 0);
  };
  const double left = x_of(0);
  const double right = x_of(bonds());
  if (!(x >= left && x < right)) return kNone;  // nor for NaN
  std::int32_t k = guess;
  if (k == kNone) {
    const auto evenly = static_cast<std::int32_t>((x - left) / (right - left) * bonds());
    k = std::clamp(evenly, 0, bonds() - 1);
  }
  while (k > 0 && x < x_of(k)) --k;
  while (k + 1 < bonds() && x >= x_of(k + 1)) ++k;
  return k;
}

double SurfaceContact::squared_distance(const ConstPoints& position, Eigen::Index point,
                                        std::int32_t bond) const {
  const auto [dx, dy, x, y] = place_at(position, point, bond);
  const double foot = std::clamp((dx * x + dy * y) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::pow(x - foot * dx, 2) + std::pow(y - foot * dy, 2);
}

std::int32_t SurfaceContact::nearest_bond(const ConstPoints& position, Eigen::Index point,
                                          std::int32_t guess) const {
  std::int32_t nearest = guess == kNone ? bond_in_direction(position, point) : guess;
  double least = squared_distance(position, point, nearest);
  for (const std::int32_t direction : {1, bonds() - 1}) {
    for (std::int32_t steps = 0; steps < bonds(); ++steps) {
      const std::int32_t next = (nearest + direction) % bonds();
      const double distance = squared_distance(position, point, next);
      if (!(distance < least)) break;
      nearest = next;
      least = distance;
    }
  }
  return nearest;
}

std::int32_t SurfaceContact::bond_in_direction(const ConstPoints& position,
                                               Eigen::Index point) const {
  const Eigen::Array2d centre = centre_of_surface(position);
  const auto angle = [&](std::int32_t row) {
    return std::atan2(position(row, 1) - centre.y(), position(row, 0) - centre.x());
  };
  const double turns = (angle(surface_.front()) - angle(static_cast<std::int32_t>(point))) /
                       (2.0 * M_PI);  // clockwise
  const double part = turns - std::floor(turns);
  return std::isfinite(part) ? std::min(static_cast<std::int32_t>(part * bonds()), bonds() - 1) : 0;
}

Eigen::Array2d SurfaceContact::centre_of_surface(const ConstPoints& position) const {
  Eigen::Array2d sum = Eigen::Array2d::Zero();
  for (std::int32_t k = 0; k < bonds(); ++k) {
    sum += position.row(surface_[static_cast<std::size_t>(k)]).transpose();
  }
  return sum / bonds();
}

void SurfaceContact::count_hops(const ConstPoints& position) {
  for (std::size_t i = 0; i < bond_.size(); ++i) {
    if (bond_[i] != counted_bond_[i]) count_hop(position, i);
  }
  counted_bond_ = bond_;
}

void SurfaceContact::count_hop(const ConstPoints& position, std::size_t i) {
  const std::int32_t from = counted_bond_[i];
  const std::int32_t to = bond_[i];
  const bool comes_back = to == std::exchange(left_bond_[i], from);
  const bool is_in_reach = from != kNone && to != kNone;
  const bool is_nearest = measure_ == GapMeasure::kNearest;
  if (!is_nearest || !is_in_reach) {
    const double change =
        potential_of(position, points_[i], to) - potential_of(position, points_[i], from);
    hops_ += change;
    hops_size_ += std::abs(change);
  }
  if (!is_in_reach) return;
  const Gap now = gap(position, points_[i], to);
  const Gap before = gap(position, points_[i], from);
  const bool is_dent = before.foot > 0.0 && before.foot < 1.0;
  if (is_nearest && (comes_back || !is_dent)) return;
  turned_ += potential_at(now.length) * (now.normal - before.normal).matrix().norm();
}

double SurfaceContact::potential_of(const ConstPoints& position, Eigen::Index point,
                                    std::int32_t bond) const {
  return bond == kNone ? 0.0 : potential_at(gap(position, point, bond).length);
}

double SurfaceContact::potential_energy(const ConstPoints& position) const {
  double energy = 0.0;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    energy += potential_of(position, points_[k], bond_[k]);
  }
  return energy;
}

double SurfaceContact::energy_beside(const ConstPoints& position) const {
  if (measure_ == GapMeasure::kNearest) return 0.0;
  const auto left = position.row(surface_.front());
  const auto right = position.row(surface_.back());
  double energy = 0.0;
  for (const std::int32_t i : points_) {
    if (position(i, 0) < left.x()) energy += potential_at(position(i, 1) - left.y());
    if (position(i, 0) > right.x()) energy += potential_at(position(i, 1) - right.y());
  }
  return energy;
}

template <class Use>
void SurfaceContact::for_each_contact(const ConstPoints& position, const Use& use) const {
  for (std::size_t k = 0; k < points_.size(); ++k) {
    if (bond_[k] == kNone) continue;
    const Gap contact = gap(position, points_[k], bond_[k]);
    use(points_[k], bond_[k], contact, force_at(contact.length));
  }
}

std::vector<PointForce> SurfaceContact::contacts(const ConstPoints& position,
                                                 double least_force) const {
  std::vector<PointForce> contacts;
  for_each_contact(position, [&](std::int32_t point, std::int32_t, const Gap& gap, double size) {
    if (size > least_force) contacts.push_back({point, size * gap.normal});
  });
  return contacts;
}

std::vector<PointForce> SurfaceContact::reactions(const ConstPoints& position,
                                                  double least_force) const {
  std::vector<PointForce> on_surface;
  for (const std::int32_t point : surface_) {
    on_surface.push_back({point, Eigen::Array2d::Zero()});
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
