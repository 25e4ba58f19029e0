#include "kernels/panel_cholesky.hpp"

#include <Eigen/Dense>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace impact {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

std::int32_t entries(const SparseMatrix& lower, std::int32_t column) {
  return lower.outerIndexPtr()[column + 1] - lower.outerIndexPtr()[column];
}

/// The rows of a column, the diagonal first.
const std::int32_t* rows_of(const SparseMatrix& lower, std::int32_t column) {
  return lower.innerIndexPtr() + lower.outerIndexPtr()[column];
}

/// Whether columns of so many elements, `zeros` of them zero, are worth one supernode of this
/// width. Measured at N = 1099 … 10⁵; the solve's time is flat about these values.
bool full_enough(std::int32_t width, std::int32_t zeros, std::int32_t elements) {
  return zeros <= (width <= 8 ? 0.6 : 0.2) * elements;
}

/// The first columns of the supernodes, and the number of columns. A column takes in the supernode
/// before it as long as that one's parent in the elimination tree is among its columns: then all
/// rows of both are rows of its last column.
std::vector<std::int32_t> find_supernodes(const SparseMatrix& lower) {
  struct Group {
    std::int32_t first;
    std::int32_t nonzeros;
  };
  std::vector<Group> groups;
  for (std::int32_t column = 0; column < lower.outerSize(); ++column) {
    Group group{column, entries(lower, column)};
    const std::int32_t below = group.nonzeros - 1;
    while (!groups.empty()) {
      const Group& before = groups.back();
      const std::int32_t last = group.first - 1;
      const bool child = entries(lower, last) > 1 && rows_of(lower, last)[1] <= column;
      const std::int32_t width = column - before.first + 1;
      const std::int32_t elements = width * (width + 1) / 2 + width * below;
      const std::int32_t nonzeros = before.nonzeros + group.nonzeros;
      if (!child || !full_enough(width, elements - nonzeros, elements)) break;
      group = {before.first, nonzeros};
      groups.pop_back();
    }
    groups.push_back(group);
  }
  std::vector<std::int32_t> first;
  first.reserve(groups.size() + 1);
  for (const Group& group : groups) first.push_back(group.first);
  first.push_back(static_cast<std::int32_t>(lower.outerSize()));
  return first;
}

}  // namespace

EliminationOrder elimination_order(const SparseMatrix& matrix) {
  EliminationOrder rows_in_order;
  Eigen::AMDOrdering<std::int32_t>()(matrix, rows_in_order);
  return rows_in_order.inverse();
}

PanelCholesky::PanelCholesky(const SparseMatrix& matrix, const EliminationOrder& order,
                             const Kernels& kernels)
    : kernels_(&kernels),
      place_(order.indices().data(), order.indices().data() + order.indices().size()) {
  SparseMatrix ordered;
  ordered = matrix.selfadjointView<Eigen::Lower>().twistedBy(order);
  const Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<std::int32_t>>
      factorisation(ordered);
  if (factorisation.info() != Eigen::Success) {
    throw std::runtime_error(
        "a matrix is not positive definite, for rounding or a number too large");
  }
  const SparseMatrix& lower = factorisation.matrixL().nestedExpression();
  const std::vector<std::int32_t> first = find_supernodes(lower);
  std::int64_t most_quads = 0;
  for (std::size_t k = 0; k + 1 < first.size(); ++k) {
    add_panel(lower, first[k], first[k + 1] - first[k]);
    most_quads = std::max(most_quads, supernodes_.back().quads);
  }
  pairs_.resize(2 * (place_.size() + 1));
  scratch_.resize(2 * static_cast<std::size_t>(kQuad * most_quads));
}

void PanelCholesky::add_panel(const SparseMatrix& lower, std::int32_t first, std::int32_t width) {
  const std::int32_t below = entries(lower, first + width - 1) - 1;
  const std::int32_t* const rows_below = rows_of(lower, first + width - 1) + 1;
  const Eigen::Index quads = (width + below + kQuad - 1) / kQuad;
  supernodes_.push_back({first, width, quads});
  for (std::int32_t k = 0; k < width; ++k) rows_.push_back(first + k);
  rows_.insert(rows_.end(), rows_below, rows_below + below);
  rows_.resize(rows_.size() + static_cast<std::size_t>(kQuad * quads - width - below),
               static_cast<std::int32_t>(lower.rows()));

  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(kQuad * quads, width);
  for (std::int32_t k = 0; k < width; ++k) {
    for (SparseMatrix::InnerIterator entry(lower, first + k); entry; ++entry) {
      const auto row = static_cast<std::int32_t>(entry.row());
      const auto place =
          row < first + width
              ? row - first
              : width + std::lower_bound(rows_below, rows_below + below, row) - rows_below;
      dense(place, k) = entry.value();
    }
  }
  Eigen::MatrixXd panel = Eigen::MatrixXd::Identity(kQuad * quads, width);
  dense.topRows(width).triangularView<Eigen::Lower>().solveInPlace(panel.topRows(width));
  panel.bottomRows(kQuad * quads - width).noalias() =
      -dense.bottomRows(kQuad * quads - width) * panel.topRows(width);
  for (Eigen::Index quad = 0; quad < quads; ++quad) {
    for (std::int32_t k = 0; k < width; ++k) {
      const double* const four = &panel(kQuad * quad, k);
      values_.insert(values_.end(), four, four + kQuad);
    }
  }
}

Panels PanelCholesky::panels() const {
  return {supernodes_.data(), static_cast<std::int64_t>(supernodes_.size()), rows_.data(),
          values_.data()};
}

void PanelCholesky::solve(LaneArray& b) {
  if (lane_rows_.coordinates() == 0) {
    lane_rows_.resize(static_cast<Eigen::Index>(place_.size()) + 1);
    lane_scratch_.resize(static_cast<Eigen::Index>(scratch_.size()));
  }
  const auto given = b.array();
  auto rows = lane_rows_.array();
  for (std::size_t i = 0; i < place_.size(); ++i) {
    rows.middleCols<2>(Eigen::Index{2} * place_[i]) =
        given.middleCols<2>(2 * static_cast<Eigen::Index>(i));
  }
  rows.rightCols<2>().setZero();
  kernels_->lanes.substitute(panels(), lane_rows_.data(), lane_scratch_.data());
  auto solution = b.array();
  for (std::size_t i = 0; i < place_.size(); ++i) {
    solution.middleCols<2>(2 * static_cast<Eigen::Index>(i)) =
        rows.middleCols<2>(Eigen::Index{2} * place_[i]);
  }
}

void PanelCholesky::solve(PointArray& b) {
  for (std::size_t i = 0; i < place_.size(); ++i) {
    double* const pair = &pairs_[2 * static_cast<std::size_t>(place_[i])];
    pair[0] = b(static_cast<Eigen::Index>(i), 0);
    pair[1] = b(static_cast<Eigen::Index>(i), 1);
  }
  std::fill(pairs_.end() - 2, pairs_.end(), 0.0);
  kernels_->substitute(panels(), pairs_.data(), scratch_.data());
  for (std::size_t i = 0; i < place_.size(); ++i) {
    const double* const pair = &pairs_[2 * static_cast<std::size_t>(place_[i])];
    b(static_cast<Eigen::Index>(i), 0) = pair[0];
    b(static_cast<Eigen::Index>(i), 1) = pair[1];
  }
}

}  // namespace impact
