#include "run/free_flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mechanics/motion.hpp"

namespace impact {
namespace {

constexpr int kMostAngles = 200;
constexpr double kLeastGap = 0.9;  // of a vertical one
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Heights of the points of a body that is turned, about its centre of mass.
Eigen::ArrayXd turned_heights(const PointArray& reference, double angle) {
  return std::sin(angle) * reference.col(0) + std::cos(angle) * reference.col(1);
}

/// How far points at these heights can come down before the wall's energy reaches the limit.
double clearance(const Eigen::ArrayXd& heights, const WallAbove& wall) {
  PointArray points(heights.size(), 2);
  points << Eigen::ArrayXd::Zero(heights.size()), heights;
  const double least = std::min(wall.law.height_of_energy(points, wall.limit), wall.threshold);
  return heights.minCoeff() - least;
}

/// `direction`: 1 counter-clockwise, −1 clockwise.
bool stays_above_turning(const PointArray& reference, const Flight& flight, const WallAbove& wall,
                         int direction) {
  const double spin = direction > 0 ? flight.counter_clockwise : flight.clockwise;
  const double radius = std::sqrt(reference.square().rowwise().sum().maxCoeff());
  const double way = spin > 0.0 ? flight.velocity / spin : kInfinity;  // R/rad
  double angle = 0.0;
  for (int k = 0; k < kMostAngles; ++k) {
    const double rise = angle > 0.0 ? way * angle : 0.0;
    const double left =
        flight.height + rise - flight.swing +
        clearance(turned_heights(reference, flight.angle + direction * angle), wall);
    if (!(left >= 0.0)) return false;
    if (way >= radius) return true;
    angle += left / (radius - way);
    if (angle >= 2.0 * M_PI) return true;
  }
  return false;
}

double wall_kinetic_energy(const System& system) {
  return system.field().kinetic_energy(system.field().others.front(), system.state());
}

double spacing_of(const Lattice& disk) { return Motion::spacing(disk.points.rows()); }

}  // namespace

bool stays_above(const PointArray& reference, const Flight& flight, const WallAbove& wall) {
  return flight.velocity > 0.0 && stays_above_turning(reference, flight, wall, 1) &&
         stays_above_turning(reference, flight, wall, -1);
}

FreeFlight::FreeFlight(Scene scene, std::shared_ptr<const Bodies> bodies)
    : scene_(std::move(scene)),
      bodies_(std::move(bodies)),
      disk_(bodies_->disk(), bodies_->all.front().triangles, bodies_->all.front().flexibility,
            scene_.material, spacing_of(bodies_->disk()), 1.0),
      spacing_(spacing_of(bodies_->disk())) {
  if (scene_.hits_disk()) disks_.emplace(scene_, *bodies_);
}

double FreeFlight::energy_bound(const System& system, double most) {
  return disks_ ? disks_->energy_bound(system, most) : bound_above_wall(system, most);
}

double FreeFlight::bound_above_wall(const System& system, double most) {
  const State& state = system.state();
  const Body disk = system.field().first_body();
  const PointArray position = disk.rows_of(state.position);
  const BodyMotion body = body_motion(position, disk.rows_of(state.velocity));
  const double v = body.velocity.y();
  if (!(v > 0.0)) return kInfinity;

  const InnerMotion inner = inner_motion(system, disk, body);
  const Surface below = surface(system);
  const double height = body.centre.y() - below.height;
  // With gravity g until the top of the flight, where v t − g t²/2 ≥ v t/2.
  const double velocity = (system.field().gravity ? 0.5 : 1.0) * v - below.speed;
  const InnerBounds bound = disk_.bounds(inner);
  const auto wall = [&](double fraction) { return wall_above(system, fraction * 0.5 * v * v); };
  if (bound.hold && disk_.is_unfolded(position)) {
    const Flight flight{height,
                        velocity,
                        rigid_rotation(disk_.reference(), position),
                        bound.counter_clockwise,
                        bound.clockwise,
                        bound.swing};
    return least_that(
        [&](double fraction) { return stays_above(disk_.reference(), flight, wall(fraction)); },
        most);
  }
  if (!(velocity > 0.0)) return kInfinity;
  const Eigen::ArrayXd lowest =
      Eigen::ArrayXd::Constant(position.rows(), height - disk_.reach_of_tethers(inner));
  return least_that([&](double fraction) { return clearance(lowest, wall(fraction)) >= 0.0; },
                    most);
}

FreeFlight::Surface FreeFlight::surface(const System& system) {
  if (bodies_->is_alone()) return {0.0, 0.0};
  const double energy = wall_kinetic_energy(system) +
                        system.field().bond_energy(system.field().others.front(), system.state());
  if (scene_.wall.boundary == Boundary::kFixed) {
    return clamped_surface(elongation(energy_margin(energy), scene_.wall_material().k_a));
  }
  const PointArray position = system.field().others.front().rows_of(system.state().position);
  if (wall_rests(system, energy)) {
    return free_surface(position, position, 2.0 * wall_kinetic_energy(system));
  }
  return free_surface(bodies_->all.back().lattice.points, position, energy_margin(energy));
}

bool FreeFlight::wall_rests(const System& system, double energy) {
  constexpr double kAtRest = 1e-6;
  const bool rested = std::exchange(wall_rested_, wall_kinetic_energy(system) < kAtRest * energy);
  return rested && wall_rested_;
}

FreeFlight::Surface FreeFlight::clamped_surface(double elongation) const {
  const PlacedBody& wall = bodies_->all.back();
  const auto bonds = static_cast<double>(wall.sides.top.size() - 1);
  const double length = wall.lattice.points(wall.sides.top.back(), 0) -
                        wall.lattice.points(wall.sides.top.front(), 0);
  const double chain = 0.5 * length + elongation * std::sqrt(0.5 * bonds);
  const double rise = 2.0 * swing(bodies_->all.back().flexibility, elongation, spacing_);
  return {elongation <= spacing_ ? std::min(rise, chain) : chain, 0.0};
}

FreeFlight::Surface FreeFlight::free_surface(const PointArray& shape, const ConstPoints& position,
                                             double energy) {
  const PointArray reference = about_the_centre(shape);
  const double centre = position.col(1).mean();
  const auto disk_points = static_cast<double>(bodies_->disk().points.rows());
  const double mass = static_cast<double>(reference.rows()) / disk_points;
  const double x = elongation(energy, scene_.wall_material().k_a);
  if (x <= spacing_ && std::isfinite(bodies_->all.back().flexibility.compliance)) {
    const double angle = rigid_rotation(reference, position);
    const double lever = reference.col(0).abs().maxCoeff();
    const double inertia = reference.square().sum() / disk_points;
    return {centre + turned_heights(reference, angle).maxCoeff() +
                swing(bodies_->all.back().flexibility, x, spacing_),
            std::sqrt(2.0 * energy * (1.0 / mass + lever * lever / inertia))};
  }
  if (!wall_tethers_) wall_tethers_.emplace(bodies_->all.back().lattice);
  return {centre + wall_tethers_->largest_distance(x), std::sqrt(2.0 * energy / mass)};
}

WallAbove FreeFlight::wall_above(const System& system, double limit) const {
  const Contact& contact = *system.field().contact();
  if (bodies_->is_alone())
    return {PotentialWall(contact.a(), contact.potential_at(0.0)), kInfinity, limit};
  return {PotentialWall(kLeastGap * contact.a(), contact.potential_at(0.0)),
          scene_.wall.threshold / kLeastGap, limit};
}

}  // namespace impact
