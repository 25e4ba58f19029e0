#include "statics/multifrontal_factor.hpp"

#include <algorithm>
#include <cstddef>

namespace impact {
namespace {

constexpr Eigen::Index kColumnsTogether = 48;

/// L₁ D L₁ᵀ of the lower triangle of a few columns, L₁ in their place.
void factorise_triangle(Eigen::Ref<Eigen::MatrixXd> a, Eigen::Ref<Eigen::VectorXd> diagonal) {
  for (Eigen::Index k = 0; k < a.cols(); ++k) {
    const Eigen::Index below = a.cols() - k - 1;
    diagonal[k] = a(k, k);
    a(k, k) = 1.0;
    const Eigen::VectorXd column = a.col(k).tail(below);
    a.col(k).tail(below) /= diagonal[k];
    for (Eigen::Index j = 0; j < below; ++j) {
      a.col(k + 1 + j).tail(below - j) -= column[j] * a.col(k).tail(below - j);
    }
  }
}

/// Eliminates all columns of a, of which the upper square is symmetric: L in their place.
void factorise_columns(Eigen::Map<Eigen::MatrixXd>& a, Eigen::Ref<Eigen::VectorXd> diagonal) {
  for (Eigen::Index first = 0; first < a.cols(); first += kColumnsTogether) {
    const Eigen::Index width = std::min(kColumnsTogether, a.cols() - first);
    const Eigen::Index next = first + width;
    auto block = a.block(first, first, width, width);
    auto d = diagonal.segment(first, width);
    factorise_triangle(block, d);
    auto below = a.block(next, first, a.rows() - next, width);
    block.triangularView<Eigen::UnitLower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
    const Eigen::MatrixXd scaled = below.topRows(a.cols() - next);
    below *= d.cwiseInverse().asDiagonal();
    a.bottomRightCorner(a.rows() - next, a.cols() - next).noalias() -= below * scaled.transpose();
  }
}

}  // namespace

MultifrontalFactor::MultifrontalFactor(const Matrix& triangle, const PointArray& position)
    : place_(static_cast<std::size_t>(position.rows())), diagonal_(2 * position.rows()) {
  const Couplings couplings(triangle, static_cast<std::int32_t>(position.rows()));
  const Dissection dissection = dissect(position, couplings);
  for (std::size_t k = 0; k < dissection.order.size(); ++k) {
    place_[static_cast<std::size_t>(dissection.order[k])] = static_cast<std::int32_t>(k);
  }
  find_fronts(dissection, couplings);
  std::vector<std::int32_t> front_of(place_.size());
  for (std::size_t k = 0; k < fronts_.size(); ++k) {
    std::fill_n(front_of.begin() + fronts_[k].first, fronts_[k].own, static_cast<std::int32_t>(k));
  }
  find_elements(triangle, front_of);
}

void MultifrontalFactor::find_fronts(const Dissection& dissection, const Couplings& couplings) {
  std::size_t values = 0;
  for (const Dissection::Part& part : dissection.parts) {
    std::vector<std::int32_t> below;
    const auto add = [&](std::int32_t place) {
      if (place >= part.end) below.push_back(place);
    };
    for (std::int32_t k = part.first; k < part.end; ++k) {
      const std::int32_t point = dissection.order[static_cast<std::size_t>(k)];
      std::for_each(couplings.begin(point), couplings.end(point),
                    [&](std::int32_t other) { add(place_[static_cast<std::size_t>(other)]); });
    }
    for (const std::int32_t child : part.children) {
      const auto& reached = fronts_[static_cast<std::size_t>(child)].below;
      std::for_each(reached.begin(), reached.end(), add);
    }
    std::sort(below.begin(), below.end());
    below.erase(std::unique(below.begin(), below.end()), below.end());
    const std::int32_t own = part.end - part.first;
    const std::size_t rows = 2 * (static_cast<std::size_t>(own) + below.size());
    fronts_.push_back({part.first, own, std::move(below), part.children, {}, values});
    values += rows * 2 * static_cast<std::size_t>(own);
  }
  values_.resize(values);
}

std::int32_t MultifrontalFactor::place_in(const Front& front, std::int32_t place) {
  if (place < front.first + front.own) return place - front.first;
  const auto at = std::lower_bound(front.below.begin(), front.below.end(), place);
  return front.own + static_cast<std::int32_t>(at - front.below.begin());
}

void MultifrontalFactor::find_elements(const Matrix& triangle,
                                       const std::vector<std::int32_t>& front_of) {
  const auto points = static_cast<std::int32_t>(place_.size());
  for (std::int32_t column = 0; column < triangle.cols(); ++column) {
    for (Matrix::InnerIterator entry(triangle, column); entry; ++entry) {
      const auto row = static_cast<std::int32_t>(entry.row());
      const std::int32_t first = place_[static_cast<std::size_t>(row % points)];
      const std::int32_t second = place_[static_cast<std::size_t>(column % points)];
      Front& front = fronts_[static_cast<std::size_t>(
          front_of[static_cast<std::size_t>(std::min(first, second))])];
      const std::int32_t a = 2 * place_in(front, first) + row / points;
      const std::int32_t b = 2 * place_in(front, second) + column / points;
      front.elements.push_back({static_cast<std::int32_t>(&entry.value() - triangle.valuePtr()),
                                std::max(a, b), std::min(a, b)});
    }
  }
}

void MultifrontalFactor::factorise(const Matrix& triangle, double shift) {
  std::vector<Eigen::MatrixXd> updates(fronts_.size());
  for (std::size_t k = 0; k < fronts_.size(); ++k) {
    updates[k] = eliminate(fronts_[k], triangle.valuePtr(), shift, updates);
  }
}

/// What is left for the points that the front reaches, in the lower triangle.
Eigen::MatrixXd MultifrontalFactor::eliminate(const Front& front, const double* values,
                                              double shift, std::vector<Eigen::MatrixXd>& updates) {
  const Eigen::Index own = Eigen::Index{2} * front.own;
  const auto below = 2 * static_cast<Eigen::Index>(front.below.size());
  Dense columns(values_.data() + front.values, own + below, own);
  Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(below, below);
  columns.setZero();
  columns.diagonal().array() += shift;
  for (const Element& element : front.elements) {
    columns(element.row, element.column) += values[element.value];
  }
  for (const std::int32_t child : front.children) {
    Eigen::MatrixXd& update = updates[static_cast<std::size_t>(child)];
    add_update(fronts_[static_cast<std::size_t>(child)], update, front, columns, rest);
    update.resize(0, 0);
  }
  if (own == 0) return rest;
  auto diagonal = diagonal_.segment(Eigen::Index{2} * front.first, own);
  factorise_columns(columns, diagonal);
  const auto factor = columns.bottomRows(below);
  const Eigen::MatrixXd scaled = factor * diagonal.asDiagonal();
  rest.triangularView<Eigen::Lower>() -= factor * scaled.transpose();
  return rest;
}

void MultifrontalFactor::add_update(const Front& child, const Eigen::MatrixXd& update,
                                    const Front& front, Dense& columns, Eigen::MatrixXd& rest) {
  const Eigen::Index own = columns.cols();
  std::vector<std::int32_t> to;
  to.reserve(2 * child.below.size());
  for (const std::int32_t place : child.below) {
    const std::int32_t row = 2 * place_in(front, place);
    to.insert(to.end(), {row, row + 1});
  }
  for (std::size_t j = 0; j < to.size(); ++j) {
    double* const column =
        to[j] < own ? &columns(0, to[j]) : rest.data() + rest.rows() * (to[j] - own) - own;
    const double* const from = &update(0, static_cast<Eigen::Index>(j));
    for (std::size_t i = j; i < to.size(); ++i) column[to[i]] += from[i];
  }
}

MultifrontalFactor::Columns MultifrontalFactor::columns_of(const Front& front) const {
  const Eigen::Index own = Eigen::Index{2} * front.own;
  return {values_.data() + front.values, own + 2 * static_cast<Eigen::Index>(front.below.size()),
          own};
}

/// b₁ ← L₁⁻¹ b₁, b₂ ← b₂ − L₂ b₁ in all fronts.
void MultifrontalFactor::forward(Eigen::VectorXd& b) const {
  Eigen::VectorXd reached;
  for (const Front& front : fronts_) {
    const Columns columns = columns_of(front);
    auto solved = b.segment(Eigen::Index{2} * front.first, columns.cols());
    columns.topRows(columns.cols()).triangularView<Eigen::UnitLower>().solveInPlace(solved);
    reached.noalias() = columns.bottomRows(columns.rows() - columns.cols()) * solved;
    const double* from = reached.data();
    for (const std::int32_t place : front.below) {
      b[Eigen::Index{2} * place] -= *from++;
      b[Eigen::Index{2} * place + 1] -= *from++;
    }
  }
}

/// b₁ ← L₁⁻ᵀ (b₁ − L₂ᵀ b₂) in all fronts.
void MultifrontalFactor::backward(Eigen::VectorXd& b) const {
  Eigen::VectorXd reached;
  for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front) {
    const Columns columns = columns_of(*front);
    reached.resize(columns.rows() - columns.cols());
    double* to = reached.data();
    for (const std::int32_t place : front->below) {
      *to++ = b[Eigen::Index{2} * place];
      *to++ = b[Eigen::Index{2} * place + 1];
    }
    auto solved = b.segment(Eigen::Index{2} * front->first, columns.cols());
    solved.noalias() -= columns.bottomRows(reached.size()).transpose() * reached;
    columns.topRows(columns.cols())
        .triangularView<Eigen::UnitLower>()
        .transpose()
        .solveInPlace(solved);
  }
}

Eigen::VectorXd MultifrontalFactor::solve(const Eigen::VectorXd& b) const {
  const auto points = static_cast<Eigen::Index>(place_.size());
  Eigen::VectorXd in_order(b.size());
  const auto for_each_coordinate = [&](const auto& visit) {
    for (Eigen::Index i = 0; i < points; ++i) {
      const Eigen::Index place = Eigen::Index{2} * place_[static_cast<std::size_t>(i)];
      visit(i, place);
      visit(points + i, place + 1);
    }
  };
  for_each_coordinate([&](Eigen::Index i, Eigen::Index place) { in_order[place] = b[i]; });
  forward(in_order);
  in_order.array() /= diagonal_.array();
  backward(in_order);
  Eigen::VectorXd u(b.size());
  for_each_coordinate([&](Eigen::Index i, Eigen::Index place) { u[i] = in_order[place]; });
  return u;
}

}  // namespace impact
