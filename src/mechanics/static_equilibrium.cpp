#include "mechanics/static_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace impact {
namespace {

using Vector = Eigen::VectorXd;

constexpr int kMostIterations = 500;
constexpr double kLongestMove = 3.0;          // in ranges 1/a of the wall
constexpr double kSufficientDecrease = 1e-4;  // of the slope (Armijo)
constexpr int kMostHalvings = 40;
constexpr double kFirstShift = 1e-6;  // in units of the stiffness matrix's largest diagonal element
constexpr int kMostShifts = 8;        // each ten times the one before

/// Whether a rigid shift along this axis (0: x, 1: y) costs no energy.
bool shifts_freely(const ForceField& field, int axis) {
  const bool supported = field.supports && !field.supports->held(axis).empty();
  return !supported && (axis == 0 || !field.wall);
}

Vector flat(const PointArray& points) {
  return Eigen::Map<const Vector>(points.data(), points.size());
}

class Search {
 public:
  Search(TangentStiffness& stiffness, ForceField& field, PointArray& position)
      : stiffness_(stiffness), field_(field), position_(position), force_(position.rows(), 2) {}

  EquilibriumSearch run(double tolerance) {
    EquilibriumSearch search;
    search.largest_force = evaluate();
    while (search.largest_force > tolerance && search.iterations < kMostIterations) {
      ++search.iterations;
      const PointArray step = newton_step();
      if (!line_search(step, search.largest_force)) break;
    }
    search.found = search.largest_force <= tolerance;
    return search;
  }

  PointArray first_step() {
    evaluate();
    return newton_step();
  }

 private:
  /// Evaluates the force at the present position; returns its largest component.
  double evaluate() {
    field_.evaluate_undamped(position_, force_);
    return force_.abs().maxCoeff();
  }

  /// The displacements u with K u = f that keep the constraint; shifted until they lead downhill.
  PointArray newton_step() {
    stiffness_.set(field_, position_);
    const double scale = stiffness_.largest_diagonal();
    const Vector force = flat(force_);
    for (int attempt = 0; attempt <= kMostShifts; ++attempt) {
      const double shift = attempt == 0 ? 0.0 : kFirstShift * scale * std::pow(10.0, attempt - 1);
      const TangentStiffness::Factors* const factors = stiffness_.factorise(shift);
      if (factors == nullptr) continue;
      Vector step = factors->solve(force);
      if (field_.hold) {
        const Vector direction = flat(field_.hold->direction());
        const Vector response = factors->solve(direction);
        step -= response * (direction.dot(step) / direction.dot(response));
      }
      if (step.dot(force) > 0.0) return shaped(step);
    }
    return force_ / scale;
  }

  /// As points, without a free shift, and no longer than the wall's range allows.
  PointArray shaped(const Vector& step) const {
    PointArray moves = Eigen::Map<const PointArray>(step.data(), position_.rows(), 2);
    for (const int axis : {0, 1}) {
      if (shifts_freely(field_, axis)) moves.col(axis) -= moves.col(axis).mean();
    }
    if (field_.wall) {
      const double longest = moves.abs().maxCoeff();
      moves *= std::min(1.0, kLongestMove / field_.wall->a() / longest);
    }
    return moves;
  }

  /// Goes along `step` as far as energy falls enough or, where energy is lost in rounding, as the
  /// largest force falls. False when neither happens.
  bool line_search(const PointArray& step, double& largest_force) {
    const PointArray start = position_;
    const double energy_at_start = field_.potential_energy(start);
    const double slope = -(step * force_).sum();
    double length = 1.0;
    for (int k = 0; k < kMostHalvings; ++k) {
      position_ = start + length * step;
      const bool falls = field_.potential_energy(position_) <
                         energy_at_start + kSufficientDecrease * length * slope;
      const double force = evaluate();
      if (falls || force < largest_force) {
        largest_force = force;
        return true;
      }
      length /= 2.0;
    }
    position_ = start;
    largest_force = evaluate();
    return false;
  }

  TangentStiffness& stiffness_;
  ForceField& field_;
  PointArray& position_;
  PointArray force_;
};

}  // namespace

void TangentStiffness::set(const ForceField& field, const PointArray& position) {
  const auto points = static_cast<std::int32_t>(position.rows());
  std::vector<Eigen::Triplet<double>> entries = field.stiffness(position);
  for (const int axis : {0, 1}) {
    if (shifts_freely(field, axis)) entries.emplace_back(axis * points, axis * points, 1.0);
  }
  if (places_.empty()) {
    const Eigen::Index coordinates = 2 * position.rows();
    matrix_.resize(coordinates, coordinates);
    find_places(entries);
  }
  matrix_.coeffs() = 0.0;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (places_[k] >= 0) matrix_.valuePtr()[places_[k]] += entries[k].value();
  }
}

void TangentStiffness::find_places(const std::vector<Eigen::Triplet<double>>& entries) {
  std::vector<Eigen::Triplet<double>> lower;
  std::copy_if(entries.begin(), entries.end(), std::back_inserter(lower),
               [](const auto& entry) { return entry.row() >= entry.col(); });
  matrix_.setFromTriplets(lower.begin(), lower.end());
  for (const auto& entry : entries) {
    const int* const rows = matrix_.innerIndexPtr();
    const int* const end = rows + matrix_.outerIndexPtr()[entry.col() + 1];
    const int* const place =
        std::lower_bound(rows + matrix_.outerIndexPtr()[entry.col()], end, entry.row());
    places_.push_back(entry.row() >= entry.col() ? place - rows : -1);
  }
  factors_.analyzePattern(matrix_);
}

const TangentStiffness::Factors* TangentStiffness::factorise(double shift) {
  factors_.setShift(shift);
  factors_.factorize(matrix_);
  return factors_.info() == Eigen::Success ? &factors_ : nullptr;
}

EquilibriumSearch EquilibriumSolver::find(ForceField& field, PointArray& position,
                                          double tolerance) {
  return Search(stiffness_, field, position).run(tolerance);
}

PointArray EquilibriumSolver::correction(ForceField field, PointArray position) {
  return Search(stiffness_, field, position).first_step();
}

}  // namespace impact
