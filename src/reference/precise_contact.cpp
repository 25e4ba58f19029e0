#include "reference/precise_contact.hpp"

#include <Eigen/SparseCholesky>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace impact {
namespace {

using Real = long double;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Array = Eigen::Array<Real, Eigen::Dynamic, 2>;
using RealMatrix = Eigen::SparseMatrix<Real>;
using Vector2 = Eigen::Matrix<Real, 2, 1>;
using Matrix2 = Eigen::Matrix<Real, 2, 2>;

constexpr int kMostIterations = 60;
/// The longest way of a point in one step, in ranges 1/a of the wall.
constexpr Real kLongestWay = 2.0L;
constexpr Real kGoodChange = 1e-15L;  // relative, of ξ

/// x of all points before y of all.
RealVector stacked(const Array& array) {
  return Eigen::Map<const RealVector>(array.data(), array.size());
}

class Equilibrium {
 public:
  Equilibrium(const PressedDisk& disk, const PointArray& near_rest)
      : disk_(disk), reference_(disk.lattice.points.cast<Real>()) {
    displacement_ = near_rest.cast<Real>() - reference_;
    const Array arm = reference_.rowwise() - reference_.colwise().mean();
    direction_.resize(arm.rows(), 2);
    direction_.col(0) = -arm.col(1);
    direction_.col(1) = arm.col(0);
    height_ = reference_.col(1) - reference_.col(1).minCoeff();
    centre();
    shift_ = shift_under_load();
  }

  Real strain() const { return (height_ + displacement_.col(1)).minCoeff(); }

  void step() {
    evaluate();
    factorise();
    const RealVector direction = stacked(direction_);
    const RealVector response = factors_.solve(direction);
    const RealVector free = factors_.solve(force_);
    const Real turned = direction.dot(stacked(displacement_) + free);
    const RealVector way = free - turned / direction.dot(response) * response;
    const Real longest = way.tail(points()).cwiseAbs().maxCoeff() * disk_.wall_a;
    const Real part = longest > kLongestWay ? kLongestWay / longest : 1.0L;
    displacement_ += part * Eigen::Map<const Array>(way.data(), points(), 2);
    centre();
  }

 private:
  Eigen::Index points() const { return reference_.rows(); }

  /// The mean displacement goes into the shift, which may be large against the strain.
  void centre() {
    const auto mean = displacement_.colwise().mean().eval();
    displacement_.rowwise() -= mean;
    shift_ += mean(1);
  }

  /// exp(−a y) of each point, over the greatest, and the shift at which the wall holds the load.
  Real shift_under_load() const {
    const Real a = disk_.wall_a;
    const auto exponent = (-a * (height_ + displacement_.col(1))).eval();
    const Real greatest = exponent.maxCoeff();
    const Real sum = (exponent - greatest).exp().sum();
    return (greatest + std::log(sum / static_cast<Real>(disk_.load))) / a;
  }

  void add_bond(const Bond& bond) {
    const Vector2 d = (reference_.row(bond.first) - reference_.row(bond.second)).transpose();
    const Vector2 delta =
        (displacement_.row(bond.first) - displacement_.row(bond.second)).transpose();
    const Real natural = d.norm();
    const Real length = (d + delta).norm();
    const Real x = (2.0L * d.dot(delta) + delta.squaredNorm()) / (length + natural);
    const Real tension = disk_.law.k_a * x + disk_.law.k_b * x * x * x;
    const Vector2 n = (d + delta) / length;
    const Matrix2 along = n * n.transpose();
    add_stiffness(bond, (disk_.law.k_a + 3.0L * disk_.law.k_b * x * x) * along +
                            tension / length * (Matrix2::Identity() - along));
    for (int axis = 0; axis < 2; ++axis) {
      force_(axis * points() + bond.first) -= tension * n(axis);
      force_(axis * points() + bond.second) += tension * n(axis);
    }
  }

  void add_stiffness(const Bond& bond, const Matrix2& stiffness) {
    for (int row = 0; row < 2; ++row) {
      for (int column = 0; column < 2; ++column) {
        const Real value = stiffness(row, column);
        add(bond.first, row, bond.first, column, value);
        add(bond.second, row, bond.second, column, value);
        add(bond.first, row, bond.second, column, -value);
        add(bond.second, row, bond.first, column, -value);
      }
    }
  }

  void add(Eigen::Index i, int row, Eigen::Index j, int column, Real value) {
    entries_.emplace_back(row * points() + i, column * points() + j, value);
  }

  /// Nothing acts along x from outside, so that a tie of one point there picks one of the
  /// equivalent places.
  void evaluate() {
    entries_.clear();
    force_ = RealVector::Zero(2 * points());
    for (const Bond& bond : disk_.lattice.bonds) add_bond(bond);
    add(0, 0, 0, 0, static_cast<Real>(disk_.law.k_a));
    const Real a = disk_.wall_a;
    const Real share = static_cast<Real>(disk_.load) / static_cast<Real>(points());
    for (Eigen::Index i = 0; i < points(); ++i) {
      const Real push = std::exp(-a * (height_(i) + displacement_(i, 1) + shift_));
      force_(points() + i) += push - share;
      add(i, 1, i, 1, a * push);
    }
    const RealVector direction = stacked(direction_);
    force_ -= direction.dot(force_) / direction.squaredNorm() * direction;
  }

  void factorise() {
    RealMatrix matrix(2 * points(), 2 * points());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    factors_.compute(matrix);
    if (factors_.info() != Eigen::Success) throw std::runtime_error("no factors of the stiffness");
  }

  PressedDisk disk_;
  Array reference_;
  Array displacement_;                            ///< of mean zero
  Array direction_;                               ///< of the held rotation
  Eigen::Array<Real, Eigen::Dynamic, 1> height_;  ///< over the lowest point of the reference
  Real shift_ = 0.0L;                             ///< at which the wall's force is exp(−a y)
  RealVector force_;
  std::vector<Eigen::Triplet<Real>> entries_;
  Eigen::SimplicialLDLT<RealMatrix> factors_;
};

}  // namespace

PreciseStrain precise_strain(const PressedDisk& disk, const PointArray& near_rest) {
  Equilibrium equilibrium(disk, near_rest);
  Real last_change = std::numeric_limits<Real>::infinity();
  for (int k = 0; k < kMostIterations; ++k) {
    const Real before = equilibrium.strain();
    equilibrium.step();
    const Real strain = equilibrium.strain();
    const Real change = std::abs((strain - before) / strain);
    const bool stagnates = change < 1e-9L && change >= 0.5L * last_change;
    if (change <= kGoodChange || stagnates) {
      return {static_cast<double>(strain), static_cast<double>(change)};
    }
    last_change = change;
  }
  throw std::runtime_error("Newton's method in long double does not converge");
}

}  // namespace impact
