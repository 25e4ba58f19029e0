#include "reduced/modal_correction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "mechanics/body_motion.hpp"

namespace impact {
namespace {

constexpr double kWayOfStep = 0.2;       // a v h
constexpr double kWayOfLastStep = 0.05;  // in the last pass
constexpr double kWayOfInstants = 1.0;   // a v between two
constexpr double kLeastForce = 0.01;     // of the greatest: where instants begin and end
constexpr double kFirstForce = 1e-4;     // likewise: where a pass begins
constexpr double kTail = 1e-3;  // times the error, of the energy before: where the wall has ended
constexpr double kStiffestOfPass = 4.0 / 1.5;  // a f h²/m on a point, with a margin
constexpr int kMostStepsOfPass = 10000;
constexpr int kMostHalvingsOfPace = 20;
constexpr int kMostCorrections = 4;
constexpr double kNegligible = 0.1;  // of the wanted error
// Margins, see ModalCorrection:
constexpr double kMarginOfLatest = 0.5;
constexpr double kByChance = 0.03;
constexpr double kMismatch = 0.02;
constexpr double kMarginOfSpace = 5.0;
constexpr double kRoundingOfForces = 1e-9;  // of forces outside the space over all
constexpr double kRoundingOfChange = 1e-11;
constexpr double kStrong = 0.1;  // of the greatest force
constexpr std::size_t kMostStrong = 6;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Instant {
  ModalState state;
  Eigen::VectorXd contact_forces;
  double angular_acceleration;
};

/// A run.
struct Pass {
  double velocity = 0.0;  ///< at the end, c
  double spin = 0.0;      ///< c/R
  double largest_force = 0.0;
  double begin = 0.0;  ///< of the instants
  std::vector<Instant> instants;
};

struct Pace {
  double step;        ///< R/c
  int steps_between;  ///< two instants
};

/// Where it is left, if the body is on its way back: the force (M c²/R) and a time (R/c).
struct End {
  double force;
  double time = kInfinity;
};

/// True of a run that went through: the wall was not too stiff for the step.
bool run_through(ModalDynamics dynamics, const Pace& pace, const End& end, Pass& pass) {
  const double most = kStiffestOfPass / (pace.step * pace.step);
  const double interval = pace.step * pace.steps_between;
  pass = {};
  const auto goes_on = [&] {
    return dynamics.state().velocity < 0.0 ||
           (dynamics.force() > end.force && dynamics.time() < end.time);
  };
  for (int steps = 0; goes_on(); ++steps) {
    if (steps > kMostStepsOfPass || !(dynamics.contact_rate() < most)) return false;
    pass.largest_force = std::max(pass.largest_force, dynamics.force());
    const bool is_instant = steps % pace.steps_between == 0 && dynamics.force() > end.force;
    if (is_instant) {
      if (pass.instants.empty()) pass.begin = dynamics.time();
      pass.instants.push_back(
          {dynamics.state(), dynamics.contact_forces(), dynamics.angular_acceleration()});
    }
    const Eigen::VectorXd before_it = dynamics.middle_rates();
    dynamics.step();
    if (is_instant) pass.instants.back().state.rates = 0.5 * (before_it + dynamics.middle_rates());
  }
  pass.velocity = dynamics.state().velocity;
  pass.spin = dynamics.spin();
  const auto is_weak = [&](const Instant& instant) {
    return instant.contact_forces.sum() < kLeastForce * pass.largest_force;
  };
  const auto first = std::find_if_not(pass.instants.begin(), pass.instants.end(), is_weak);
  pass.begin += interval * static_cast<double>(first - pass.instants.begin());
  pass.instants.erase(pass.instants.begin(), first);
  while (!pass.instants.empty() && is_weak(pass.instants.back())) pass.instants.pop_back();
  return std::isfinite(pass.velocity) && !pass.instants.empty();
}

/// The amplitudes or rates of all instants.
Eigen::MatrixXd joined(const std::vector<Instant>& instants, Eigen::VectorXd ModalState::*numbers) {
  Eigen::MatrixXd all((instants.front().state.*numbers).size(),
                      static_cast<Eigen::Index>(instants.size()));
  for (Eigen::Index k = 0; k < all.cols(); ++k) {
    all.col(k) = instants[static_cast<std::size_t>(k)].state.*numbers;
  }
  return all;
}

/// By a right angle.
Eigen::VectorXd turned(const Eigen::VectorXd& u) {
  const Eigen::Index n = u.size() / 2;
  Eigen::VectorXd result(u.size());
  result << -u.tail(n), u.head(n);
  return result;
}

/// Forces on all points, as seen from the body.
class AllForces {
 public:
  AllForces(const ModalSystem& system, const ForceField& field)
      : modes_(*system.modes), bonds_(field.bonds) {
    field.resize(position_);
    field.resize(force_);
  }

  /// Of the bonds, without damping, at displacements.
  Eigen::VectorXd elastic(const Eigen::VectorXd& u) {
    position_.reshaped() = modes_.arm.reshaped() + u.array();
    bonds_.evaluate_elastic(position_, force_);
    return force_.reshaped().matrix();
  }

  /// Of the damping, at velocities.
  Eigen::VectorXd damping(const Eigen::VectorXd& velocity) {
    position_.reshaped() = velocity.array();
    bonds_.evaluate_damping(position_, force_);
    return force_.reshaped().matrix();
  }

  /// Of the wall.
  Eigen::VectorXd wall(const Instant& instant) const {
    const Eigen::Index n = modes_.arm.rows();
    const double angle = instant.state.amplitudes(0) / std::sqrt(modes_.inertia);
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * n);
    for (std::size_t k = 0; k < modes_.points.size(); ++k) {
      const double size = instant.contact_forces(static_cast<Eigen::Index>(k));
      forces(modes_.points[k]) = size * std::sin(angle);
      forces(n + modes_.points[k]) = size * std::cos(angle);
    }
    return forces;
  }

 private:
  const BulkModes& modes_;
  BondForces bonds_;
  PointArray position_;
  PointArray force_;
};

/// The forces on the modes that a frame which turns adds, with those of the damping of what turns.
Eigen::VectorXd forces_of_turning(const ModalSystem& system, const Instant& instant) {
  const BulkModes& modes = *system.modes;
  const double spin = instant.state.rates(0) / std::sqrt(modes.inertia);
  Eigen::VectorXd amplitudes = instant.state.amplitudes;
  Eigen::VectorXd rates = instant.state.rates;
  amplitudes(0) = rates(0) = 0.0;
  const Eigen::VectorXd across = modes.turning * amplitudes;
  return spin * spin * (modes.reach + amplitudes) - instant.angular_acceleration * across -
         spin * (2.0 * modes.turning * rates + system.law.eta * (modes.damping * across));
}

/// The defect on the modes. On the rotation the model has the torque of the wall at the lever arms
/// of the displaced points, which the bonds give anew.
ForceCourse defect(const ModalSystem& system, const ForceField& field, const Pass& pass,
                   const Pace& pace) {
  const BulkModes& modes = *system.modes;
  const Eigen::MatrixXd amplitudes = joined(pass.instants, &ModalState::amplitudes);
  const Eigen::MatrixXd u = elastic_displacements(modes, amplitudes);
  AllForces all(system, field);
  Eigen::MatrixXd elastic(u.rows(), u.cols());
  Eigen::MatrixXd others(amplitudes.rows(), u.cols());
  for (Eigen::Index k = 0; k < u.cols(); ++k) {
    const Instant& instant = pass.instants[static_cast<std::size_t>(k)];
    elastic.col(k) = all.elastic(u.col(k));
    others.col(k) = forces_of_turning(system, instant) +
                    system.law.k_a * modes.stiffness.cwiseProduct(amplitudes.col(k));
    others(0, k) -= turned(u.col(k)).dot(all.wall(instant)) / std::sqrt(modes.inertia);
  }
  others += modes.onto_modes * elastic;
  return {pass.begin, pace.step * pace.steps_between, std::move(others)};
}

/// w = K⁺ r of forces r, and rᵀ w.
struct Response {
  Eigen::VectorXd displacements;
  double twice_energy;
};

Response response_to(const Eigen::VectorXd& forces, double k_a, Compliance& compliance) {
  PointArray load = PointArray::Zero(forces.size(), 2);
  load.col(0) = forces.array();
  compliance.respond(load);
  Eigen::VectorXd displacements = load.col(0).matrix() / k_a;
  const double energy = forces.dot(displacements);
  return {std::move(displacements), energy};
}

/// Twice the energy of the response to forces outside the space of modes, M c². What bonds at the
/// displacements u, which the elastic forces belong to, are beyond linear ones when they respond
/// has a response in turn, and so on: a geometric series, as long as that shrinks.
double twice_energy_outside(AllForces& all, double k_a, Compliance& compliance,
                            const Eigen::VectorXd& u, const Eigen::VectorXd& elastic,
                            const Eigen::VectorXd& rest) {
  const Response first = response_to(rest, k_a, compliance);
  if (rest.norm() < kRoundingOfForces * elastic.norm()) return first.twice_energy;
  const Response second =
      response_to(all.elastic(u + first.displacements) - elastic + rest, k_a, compliance);
  const double ratio = std::sqrt(second.twice_energy / first.twice_energy);
  return ratio < 1.0 ? first.twice_energy / std::pow(1.0 - ratio, 2) : kInfinity;
}

/// Of points that are not among those in contact, at displacements u.
double energy_of_others(const ModalSystem& system, const Instant& instant,
                        const Eigen::VectorXd& u) {
  const BulkModes& modes = *system.modes;
  const Eigen::Index n = modes.arm.rows();
  const double angle = instant.state.amplitudes(0) / std::sqrt(modes.inertia);
  Eigen::ArrayXd height = instant.state.height +
                          std::sin(angle) * (modes.arm.col(0) + u.head(n).array()) +
                          std::cos(angle) * (modes.arm.col(1) + u.tail(n).array());
  for (const std::int32_t point : modes.points) height(point) = kInfinity;
  return system.wall.potential_at(0.0) * (-system.wall.a() * height).exp().sum();
}

/// Some of those at which the force is at least a tenth of the greatest.
std::vector<Instant> strongest(const Pass& pass) {
  std::vector<std::size_t> strong;
  for (std::size_t k = 0; k < pass.instants.size(); ++k) {
    if (pass.instants[k].contact_forces.sum() > kStrong * pass.largest_force) strong.push_back(k);
  }
  const std::size_t stride = (strong.size() + kMostStrong - 1) / kMostStrong;
  std::vector<Instant> some;
  for (std::size_t k = 0; k < strong.size(); k += stride) some.push_back(pass.instants[strong[k]]);
  return some;
}

/// Of what is left out at the strongest instants, over the energy that is left.
double part_outside(const ModalSystem& system, const ForceField& field, Compliance& compliance,
                    const Pass& pass) {
  const BulkModes& modes = *system.modes;
  const std::vector<Instant> instants = strongest(pass);
  const Eigen::MatrixXd u = elastic_displacements(modes, joined(instants, &ModalState::amplitudes));
  const Eigen::MatrixXd velocities = modes.onto_points * joined(instants, &ModalState::rates);
  AllForces all(system, field);
  Eigen::MatrixXd elastic(u.rows(), u.cols());
  Eigen::MatrixXd rest(u.rows(), u.cols());
  for (Eigen::Index k = 0; k < u.cols(); ++k) {
    elastic.col(k) = all.elastic(u.col(k));
    rest.col(k) = all.wall(instants[static_cast<std::size_t>(k)]) + elastic.col(k);
    if (field.bonds.damped()) rest.col(k) += all.damping(velocities.col(k));
  }
  rest -= field.point_mass * (modes.onto_points * (modes.onto_modes * rest));
  for (auto along : {rest.topRows(u.rows() / 2), rest.bottomRows(u.rows() / 2)}) {
    along.rowwise() -= along.colwise().mean();
  }
  double most = 0.0;
  for (Eigen::Index k = 0; k < u.cols(); ++k) {
    most = std::max(
        most, twice_energy_outside(all, system.law.k_a, compliance, u.col(k), elastic.col(k),
                                   rest.col(k)) +
                  2.0 * energy_of_others(system, instants[static_cast<std::size_t>(k)], u.col(k)));
  }
  return kMarginOfSpace * most / (pass.velocity * pass.velocity);
}

/// Of the answers of two passes, one after the other.
struct Change {
  double restitution = 0.0;
  double spin = 0.0;
  double force = 0.0;
};

Change change_of(const Pass& before, const Pass& after) {
  return {std::abs(after.velocity / before.velocity - 1.0), std::abs(after.spin - before.spin),
          std::abs(after.largest_force / before.largest_force - 1.0)};
}

/// Repeated passes, each with the defect of the one before it.
class Iteration {
 public:
  Iteration(const ModalSystem& system, const ForceField& field, const State& start, double error)
      : field_(field),
        pace_{kWayOfStep / (system.wall.a() * std::abs(start.velocity.col(1).mean())),
              static_cast<int>(std::lround(kWayOfInstants / kWayOfStep))},
        dynamics_(system, modal_state(*system.modes, start), pace_.step),
        end_{kTail * error * dynamics_.kinetic_energy() * system.wall.a()} {}

  /// The pass without a correction, with a step for which the wall is not too stiff. Those after it
  /// begin where it met the wall. False: none.
  bool begin() {
    for (int halvings = 0; halvings < kMostHalvingsOfPace; ++halvings) {
      if (run_through(dynamics_, pace_, end_, pass_)) {
        while (dynamics_.force() < kFirstForce * pass_.largest_force) dynamics_.step();
        return true;
      }
      pace_.step *= 0.5;
      pace_.steps_between *= 2;
      dynamics_.set_step(pace_.step);
    }
    return false;
  }

  /// False if the corrected body does not come back.
  bool improve() {
    correct();
    const Pass before = std::exchange(pass_, {});
    if (!run_through(dynamics_, pace_, end_, pass_)) return false;
    const Change change = change_of(before, pass_);
    if (++corrections_ == 1) first_ = change;
    before_ = std::exchange(latest_, change);
    return true;
  }

  /// The correction from a pass in steps that are short enough. False if that does not come back.
  bool refine() {
    const ModalState& start = dynamics_.state();
    const double way = dynamics_.system().wall.a() * std::abs(start.velocity) * pace_.step;
    if (const auto parts = static_cast<int>(std::ceil(way / kWayOfLastStep)); parts > 1) {
      const End end{end_.force, time_of(pass_.instants.size()) - 0.5 * pace_.step};
      pace_.step /= parts;
      pace_.steps_between *= parts;
      dynamics_.set_step(pace_.step);
      if (!run_through(dynamics_, pace_, end, pass_)) return false;
    }
    correct();
    return true;
  }

  /// Of e, what the iteration leaves; infinite if that is not known.
  double rest() const { return rest_of(&Change::restitution); }

  ModelError left_out(Compliance& compliance) const {
    const double outside = part_outside(dynamics_.system(), field_, compliance, pass_);
    const double impulse = pass_.velocity - dynamics_.state().velocity;
    return {rest() + kMismatch * first_.restitution + outside,
            rest_of(&Change::spin) + kMismatch * first_.spin +
                outside * impulse / dynamics_.system().modes->inertia,
            rest() + rest_of(&Change::force) + std::sqrt(outside)};
  }
  /// Of a triangle, at the strongest instants.
  double least_area_left(const Triangles& triangles) const {
    const BulkModes& modes = *dynamics_.system().modes;
    const Eigen::MatrixXd u =
        elastic_displacements(modes, joined(strongest(pass_), &ModalState::amplitudes));
    double least = 1.0;
    for (Eigen::Index k = 0; k < u.cols(); ++k) {
      const PointArray displaced = modes.arm + u.col(k).reshaped(modes.arm.rows(), 2).array();
      least = std::min(least, triangles.least_area_left(modes.arm, displaced));
    }
    return least;
  }
  std::shared_ptr<const ForceCourse> correction() const { return dynamics_.system().correction; }

 private:
  /// Of an instant of the latest pass, counted from its first.
  double time_of(std::size_t instant) const {
    return pass_.begin + static_cast<double>(instant) * pace_.step * pace_.steps_between;
  }

  void correct() {
    dynamics_.set_correction(
        std::make_shared<const ForceCourse>(defect(dynamics_.system(), field_, pass_, pace_)));
  }

  /// A single change may be small by chance.
  double rest_of(double Change::*number) const {
    if (corrections_ < 2) return kInfinity;
    const double latest = latest_.*number;
    const double before = before_.*number;
    if (std::max(before, latest) < kRoundingOfChange) return kRoundingOfChange;
    if (latest == 0.0) return kByChance * before;
    if (latest >= before) return kInfinity;
    return std::max(
        {latest * latest / (before - latest), kMarginOfLatest * latest, kByChance * before});
  }

  const ForceField& field_;
  Pace pace_;
  ModalDynamics dynamics_;  ///< at the start
  End end_;
  Pass pass_;
  int corrections_ = 0;
  Change first_;
  Change before_;
  Change latest_;
};

}  // namespace

Eigen::MatrixXd elastic_displacements(const BulkModes& modes, const Eigen::MatrixXd& amplitudes) {
  Eigen::MatrixXd elastic = amplitudes;
  elastic.row(0).setZero();
  return modes.onto_points * elastic;
}

ModalState modal_state(const BulkModes& modes, const State& start) {
  const BodyMotion motion = body_motion(start.position, start.velocity);
  ModalState state;
  state.height = motion.centre.y();
  state.velocity = motion.velocity.y();
  state.amplitudes = Eigen::VectorXd::Zero(modes.stiffness.size());
  state.rates = Eigen::VectorXd::Zero(modes.stiffness.size());
  return state;
}

ModalCorrection modal_correction(const ModalSystem& system, const ForceField& field,
                                 const Triangles& triangles, const State& start,
                                 Compliance& compliance, double error) {
  Iteration iteration(system, field, start, error);
  bool goes_on = iteration.begin();
  for (int k = 0; goes_on && k < kMostCorrections; ++k) {
    goes_on = iteration.improve();
    if (goes_on && iteration.rest() <= kNegligible * error) break;
  }
  if (!goes_on || !iteration.refine()) return {nullptr, {kInfinity, kInfinity, kInfinity}};
  ModelError left_out = iteration.left_out(compliance);
  left_out.may_fold = iteration.least_area_left(triangles) < ModelError::kLeastAreaLeft;
  return {iteration.correction(), left_out};
}

}  // namespace impact
