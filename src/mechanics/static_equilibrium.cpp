#include "mechanics/static_equilibrium.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <vector>

namespace impact {
namespace {

using Vector = Eigen::VectorXd;
using Factorisation = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

constexpr int kMostIterations = 500;
constexpr double kLongestMove = 3.0;          // in ranges 1/a of the wall
constexpr double kSufficientDecrease = 1e-4;  // of the slope (Armijo)
constexpr int kMostHalvings = 40;
constexpr double kFirstShift = 1e-6;  // in units of the stiffness matrix's largest diagonal element
constexpr int kMostShifts = 8;        // each ten times the one before

Vector flat(const PointArray& points) {
  return Eigen::Map<const Vector>(points.data(), points.size());
}

class Search {
 public:
  Search(ForceField& field, PointArray& position)
      : field_(field), position_(position), force_(position.rows(), 2) {}

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

  /// Whether a rigid shift along this axis (0: x, 1: y) costs no energy.
  bool shifts_freely(int axis) const {
    const bool supported = field_.supports && !field_.supports->held(axis).empty();
    return !supported && (axis == 0 || !field_.wall);
  }

  /// The tangent stiffness, the supported coordinates uncoupled, and with one point tied to its
  /// place along an axis that shifts freely. Since nothing acts along it from outside, the tie
  /// carries no force, and only picks one of the equivalent shifts.
  Eigen::SparseMatrix<double> stiffness() const {
    const auto points = static_cast<std::int32_t>(position_.rows());
    const Eigen::Index coordinates = 2 * position_.rows();
    std::vector<Eigen::Triplet<double>> entries = field_.stiffness(position_);
    for (const int axis : {0, 1}) {
      if (shifts_freely(axis)) entries.emplace_back(axis * points, axis * points, 1.0);
    }
    Eigen::SparseMatrix<double> matrix(coordinates, coordinates);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  /// The displacements u with K u = f that keep the constraint; shifted until they lead downhill.
  PointArray newton_step() {
    const Eigen::SparseMatrix<double> matrix = stiffness();
    const double scale = matrix.diagonal().maxCoeff();
    const Vector force = flat(force_);
    Factorisation factorisation;
    factorisation.analyzePattern(matrix);
    for (int attempt = 0; attempt <= kMostShifts; ++attempt) {
      const double shift = attempt == 0 ? 0.0 : kFirstShift * scale * std::pow(10.0, attempt - 1);
      factorisation.setShift(shift);
      factorisation.factorize(matrix);
      if (factorisation.info() != Eigen::Success) continue;
      Vector step = factorisation.solve(force);
      if (field_.hold) {
        const Vector direction = flat(field_.hold->direction());
        const Vector response = factorisation.solve(direction);
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
      if (shifts_freely(axis)) moves.col(axis) -= moves.col(axis).mean();
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

  ForceField& field_;
  PointArray& position_;
  PointArray force_;
};

}  // namespace

EquilibriumSearch find_equilibrium(ForceField& field, PointArray& position, double tolerance) {
  return Search(field, position).run(tolerance);
}

PointArray equilibrium_correction(ForceField field, PointArray position) {
  return Search(field, position).first_step();
}

}  // namespace impact
