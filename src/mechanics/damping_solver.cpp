#include "mechanics/damping_solver.hpp"

#include <Eigen/SparseCholesky>
#include <cmath>

namespace impact {

DampingSolver::Factor::Factor(const Eigen::SparseMatrix<double>& matrix) {
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factorisation(matrix);
  const Eigen::SparseMatrix<double>& lower = factorisation.matrixL().nestedExpression();
  const auto& order = factorisation.permutationP().indices();
  place.assign(order.data(), order.data() + order.size());
  begin.push_back(0);
  for (Eigen::Index column = 0; column < lower.outerSize(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, column); entry; ++entry) {
      if (entry.row() == column) {
        inverse_diagonal.push_back(1.0 / entry.value());
      } else {
        row.push_back(static_cast<std::int32_t>(entry.row()));
        value.push_back(entry.value());
      }
    }
    begin.push_back(static_cast<std::int32_t>(row.size()));
  }
}

DampingSolver::DampingSolver(const ForceField& field, double scale) {
  const auto matrix = [&](int axis) {
    std::vector<Eigen::Triplet<double>> entries;
    for (const Eigen::Triplet<double>& entry : field.damping(axis)) {
      entries.emplace_back(entry.row(), entry.col(), scale / field.point_mass * entry.value());
    }
    const auto points = static_cast<std::int32_t>(field.bonds.points());
    for (std::int32_t i = 0; i < points; ++i) entries.emplace_back(i, i, 1.0);
    Eigen::SparseMatrix<double> sum(points, points);
    sum.setFromTriplets(entries.begin(), entries.end());
    return sum;
  };
  factors_.emplace_back(matrix(0));
  if (field.viscous_boundary || field.supports) factors_.emplace_back(matrix(1));
  work_.resize(2 * factors_.front().place.size());
  if (!field.hold) return;
  PointArray response = field.hold->direction();
  solve(response);
  hold_direction_ = field.hold->direction();
  hold_response_ = response / (hold_direction_ * response).sum();
}

void DampingSolver::solve(PointArray& velocity) {
  if (factors_.size() == 1) {
    substitute<2>(factors_[0], 0, velocity);
  } else {
    for (int axis = 0; axis < 2; ++axis) {
      substitute<1>(factors_[static_cast<std::size_t>(axis)], axis, velocity);
    }
  }
  if (hold_direction_.size() == 0) return;
  const double broken = (hold_direction_ * velocity).sum();
  velocity -= broken * hold_response_;
}

template <int kColumns>
void DampingSolver::substitute(const Factor& factor, int axis, PointArray& velocity) {
  using Row = Eigen::Array<double, kColumns, 1>;
  const auto at = [&](std::int32_t place) {
    return Eigen::Map<Row>(work_.data() + static_cast<std::ptrdiff_t>(kColumns) * place);
  };
  const auto size = static_cast<std::int32_t>(factor.place.size());
  for (std::int32_t i = 0; i < size; ++i) {
    at(factor.place[static_cast<std::size_t>(i)]) =
        velocity.row(i).template segment<kColumns>(axis).transpose();
  }
  for (std::int32_t column = 0; column < size; ++column) {
    const auto j = static_cast<std::size_t>(column);
    const Row solved = at(column) * factor.inverse_diagonal[j];
    at(column) = solved;
    for (std::int32_t k = factor.begin[j]; k < factor.begin[j + 1]; ++k) {
      const auto entry = static_cast<std::size_t>(k);
      at(factor.row[entry]) -= factor.value[entry] * solved;
    }
  }
  for (std::int32_t column = size - 1; column >= 0; --column) {
    const auto j = static_cast<std::size_t>(column);
    Row sum = at(column);
    for (std::int32_t k = factor.begin[j]; k < factor.begin[j + 1]; ++k) {
      const auto entry = static_cast<std::size_t>(k);
      sum -= factor.value[entry] * at(factor.row[entry]);
    }
    at(column) = sum * factor.inverse_diagonal[j];
  }
  for (std::int32_t i = 0; i < size; ++i) {
    velocity.row(i).template segment<kColumns>(axis) =
        at(factor.place[static_cast<std::size_t>(i)]).transpose();
  }
}

}  // namespace impact
