#include "run/free_flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace impact {
namespace {

constexpr int kMostAngles = 200;
constexpr double kEnergyMargin = 1.1;
constexpr double kRounding = 1e-9;         // of an energy that is the difference of two
constexpr double kFirstOrder = 1.0 / 3.0;  // of the spacing
constexpr double kLeastGap = 0.9;          // of a vertical one
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double energy_margin(double energy) { return kEnergyMargin * energy; }

PointArray about_the_centre(const ConstPoints& points) {
  return points.rowwise() - points.colwise().mean();
}

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
  const auto velocity = system.state().velocity.bottomRows(system.field().wall_points);
  return 0.5 * system.field().point_mass * velocity.square().sum();
}

}  // namespace

bool stays_above(const PointArray& reference, const Flight& flight, const WallAbove& wall) {
  return flight.velocity > 0.0 && stays_above_turning(reference, flight, wall, 1) &&
         stays_above_turning(reference, flight, wall, -1);
}

FreeFlight::FreeFlight(Scene scene, std::shared_ptr<const Bodies> bodies)
    : scene_(std::move(scene)),
      bodies_(std::move(bodies)),
      reference_(about_the_centre(bodies_->disk.points)),
      inertia_(reference_.square().sum() / static_cast<double>(reference_.rows())),
      spacing_(std::sqrt(M_PI / static_cast<double>(reference_.rows()))) {}

bool FreeFlight::is_for_good(const System& system, double fraction) {
  const State& state = system.state();
  const Eigen::Index points = reference_.rows();
  const PointArray position = state.position.topRows(points);
  const BodyMotion body = body_motion(position, state.velocity.topRows(points));
  const double v = body.velocity.y();
  if (!(v > 0.0)) return false;

  const EnergyLedger ledger = system.ledger();
  const InnerMotion inner{ledger.kinetic_rotation + ledger.kinetic_internal + ledger.bonds,
                          body.angular_momentum};
  const Surface below = surface(system, ledger.wall_lattice);
  const WallAbove wall = wall_above(system, fraction * 0.5 * v * v);
  const double height = body.centre.y() - below.height;
  const double velocity = v - below.speed;
  const InnerBounds bound = bounds(inner);
  if (bound.hold && bodies_->triangles.turned_over(position) == 0) {
    return stays_above(reference_,
                       {height, velocity, rigid_rotation(reference_, position),
                        bound.counter_clockwise, bound.clockwise, bound.swing},
                       wall);
  }
  if (!(velocity > 0.0)) return false;
  if (!tethers_) tethers_.emplace(bodies_->disk);
  const double outermost =
      tethers_->largest_distance(elongation(energy_margin(inner.energy), scene_.material));
  return clearance(Eigen::ArrayXd::Constant(points, height - outermost), wall) >= 0.0;
}

InnerBounds FreeFlight::bounds(const InnerMotion& motion) const {
  constexpr int kIterations = 3;
  constexpr double kLargestDisplacement = 0.25;  // of the radius of gyration
  const bool damped = scene_.material.eta != 0.0;
  const double omega = bodies_->flexibility.lowest_frequency * std::sqrt(scene_.material.k_a);
  const double gyration = std::sqrt(inertia_);
  const double all = energy_margin(motion.energy);
  const double l = std::abs(motion.angular_momentum);
  double energy = all;
  double displacement = std::sqrt(2.0 * energy) / omega;  // root mean square, of all points
  for (int k = 0; k < kIterations && !damped; ++k) {
    const double rotation = 0.5 * std::pow(l / (gyration + displacement), 2);
    energy = energy_margin(std::max(0.0, motion.energy - rotation)) + kRounding * motion.energy;
    displacement = std::sqrt(2.0 * energy) / omega;
  }
  const double x = elongation(energy, scene_.material);
  InnerBounds bounds{};
  bounds.hold = x <= kFirstOrder * spacing_ && displacement <= kLargestDisplacement * gyration &&
                std::isfinite(bodies_->flexibility.compliance);
  bounds.swing = swing(bodies_->flexibility, x);
  const double least_gyration = gyration - displacement;
  if (damped) {
    bounds.clockwise = bounds.counter_clockwise = std::sqrt(2.0 * all) / least_gyration;
    return bounds;
  }
  const double least_inertia = least_gyration * least_gyration;
  const double of_vibrations = energy / omega;
  const double along = (l + of_vibrations) / least_inertia;
  const double against = std::max(0.0, of_vibrations - l) / least_inertia;
  const bool turns_left = motion.angular_momentum > 0.0;
  bounds.counter_clockwise = turns_left ? along : against;
  bounds.clockwise = turns_left ? against : along;
  return bounds;
}

FreeFlight::Surface FreeFlight::surface(const System& system, double energy) {
  if (!bodies_->wall) return {0.0, 0.0};
  if (scene_.wall.boundary == Boundary::kFixed) {
    return clamped_surface(elongation(energy_margin(energy), scene_.wall_material()));
  }
  const PointArray position = system.state().position.bottomRows(system.field().wall_points);
  if (wall_rests(system, energy)) {
    return free_surface(position, position, 2.0 * wall_kinetic_energy(system));
  }
  return free_surface(bodies_->wall->lattice.points, position, energy_margin(energy));
}

bool FreeFlight::wall_rests(const System& system, double energy) {
  constexpr double kAtRest = 1e-6;
  const bool rested = std::exchange(wall_rested_, wall_kinetic_energy(system) < kAtRest * energy);
  return rested && wall_rested_;
}

FreeFlight::Surface FreeFlight::clamped_surface(double elongation) const {
  const ElasticWallBody& wall = *bodies_->wall;
  const auto bonds = static_cast<double>(wall.sides.top.size() - 1);
  const double length = wall.lattice.points(wall.sides.top.back(), 0) -
                        wall.lattice.points(wall.sides.top.front(), 0);
  const double chain = 0.5 * length + elongation * std::sqrt(0.5 * bonds);
  const double rise = 2.0 * swing(bodies_->wall_flexibility, elongation);
  return {elongation <= spacing_ ? std::min(rise, chain) : chain, 0.0};
}

FreeFlight::Surface FreeFlight::free_surface(const PointArray& shape, const ConstPoints& position,
                                             double energy) {
  const PointArray reference = about_the_centre(shape);
  const double centre = position.col(1).mean();
  const double mass =
      static_cast<double>(reference.rows()) / static_cast<double>(reference_.rows());
  const double x = elongation(energy, scene_.wall_material());
  if (x <= spacing_ && std::isfinite(bodies_->wall_flexibility.compliance)) {
    const double angle = rigid_rotation(reference, position);
    const double lever = reference.col(0).abs().maxCoeff();
    const double inertia = reference.square().sum() / static_cast<double>(reference_.rows());
    return {
        centre + turned_heights(reference, angle).maxCoeff() + swing(bodies_->wall_flexibility, x),
        std::sqrt(2.0 * energy * (1.0 / mass + lever * lever / inertia))};
  }
  if (!wall_tethers_) wall_tethers_.emplace(bodies_->wall->lattice);
  return {centre + wall_tethers_->largest_distance(x), std::sqrt(2.0 * energy / mass)};
}

double FreeFlight::swing(const Flexibility& body, double elongation) const {
  return std::sqrt(body.compliance) * elongation * (1.0 + elongation / spacing_);
}

double FreeFlight::elongation(double energy, const Scene::Material& material) {
  return std::sqrt(2.0 * energy / material.k_a);
}

WallAbove FreeFlight::wall_above(const System& system, double limit) const {
  const WallContact& contact = *system.field().contact();
  if (!bodies_->wall)
    return {PotentialWall(contact.a(), contact.potential_at(0.0)), kInfinity, limit};
  return {PotentialWall(kLeastGap * contact.a(), contact.potential_at(0.0)),
          scene_.wall.threshold / kLeastGap, limit};
}

}  // namespace impact
