#include "mechanics/panel_cholesky.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cstddef>

// For processors with AVX2 and for all others; the program chooses when it starts.
#ifdef __x86_64__
#define IMPACT_TARGETS __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define IMPACT_TARGETS
#endif

namespace impact {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Supernode = PanelCholesky::Supernode;
using Quad = PanelCholesky::Quad;

constexpr std::int32_t kQuad = 4;

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
  for (const Group& group : groups) first.push_back(group.first);
  first.push_back(static_cast<std::int32_t>(lower.outerSize()));
  return first;
}

double sum(const Quad& quad) { return (quad.of[0] + quad.of[1]) + (quad.of[2] + quad.of[3]); }

/// The forward substitution of one supernode; `work` holds x and y of each row, `own` those of the
/// supernode as they were.
IMPACT_TARGETS
void forward(const Supernode& node, const Quad* panel, const std::int32_t* rows, double* work,
             double* own) {
  double* const solved = work + 2 * node.first;
  std::copy(solved, solved + 2 * node.width, own);
  std::fill(solved, solved + 2 * node.width, 0.0);
  for (std::int32_t quad = 0; quad < node.quads; ++quad) {
    Quad x{};
    Quad y{};
    const std::int32_t end = std::min(node.width, kQuad * (quad + 1));  // Q₁ is triangular
    for (std::int32_t k = 0; k < end; ++k) {
      x.of += panel[k].of * own[2 * k];
      y.of += panel[k].of * own[2 * k + 1];
    }
    for (std::int32_t r = 0; r < kQuad; ++r) {
      double* const row = work + 2 * rows[r];
      row[0] += x.of[r];
      row[1] += y.of[r];
    }
    panel += node.width;
    rows += kQuad;
  }
}

/// The backward substitution of one supernode; `right` holds x and y of the rows of each quad.
IMPACT_TARGETS
void backward(const Supernode& node, const Quad* panel, const std::int32_t* rows, double* work,
              Quad* right) {
  for (std::int32_t quad = 0; quad < node.quads; ++quad) {
    for (std::int32_t r = 0; r < kQuad; ++r) {
      const double* const row = work + 2 * rows[r];
      right[2 * quad].of[r] = row[0];
      right[2 * quad + 1].of[r] = row[1];
    }
    rows += kQuad;
  }
  double* const own = work + 2 * node.first;
  constexpr std::int32_t kTogether = 4;
  std::int32_t k = 0;
  for (; k + kTogether <= node.width; k += kTogether) {
    Quad x[kTogether]{};
    Quad y[kTogether]{};
    for (std::int32_t quad = k / kQuad; quad < node.quads; ++quad) {  // Q₁ is triangular
      const Quad* const columns = panel + quad * node.width + k;
      for (std::int32_t c = 0; c < kTogether; ++c) {
        x[c].of += columns[c].of * right[2 * quad].of;
        y[c].of += columns[c].of * right[2 * quad + 1].of;
      }
    }
    for (std::int32_t c = 0; c < kTogether; ++c) {
      own[2 * (k + c)] = sum(x[c]);
      own[2 * (k + c) + 1] = sum(y[c]);
    }
  }
  for (; k < node.width; ++k) {
    Quad x{};
    Quad y{};
    for (std::int32_t quad = k / kQuad; quad < node.quads; ++quad) {
      x.of += panel[quad * node.width + k].of * right[2 * quad].of;
      y.of += panel[quad * node.width + k].of * right[2 * quad + 1].of;
    }
    own[2 * k] = sum(x);
    own[2 * k + 1] = sum(y);
  }
}

}  // namespace

PanelCholesky::PanelCholesky(const SparseMatrix& matrix) {
  const Eigen::SimplicialLLT<SparseMatrix> factorisation(matrix);
  const SparseMatrix& lower = factorisation.matrixL().nestedExpression();
  const auto& order = factorisation.permutationP().indices();
  place_.assign(order.data(), order.data() + order.size());
  const std::vector<std::int32_t> first = find_supernodes(lower);
  std::int32_t most_quads = 0;
  for (std::size_t k = 0; k + 1 < first.size(); ++k) {
    add_panel(lower, first[k], first[k + 1] - first[k]);
    most_quads = std::max(most_quads, supernodes_.back().quads);
  }
  work_.resize(2 * (place_.size() + 1));
  own_.resize(2 * kQuad * static_cast<std::size_t>(most_quads));
  right_.resize(2 * static_cast<std::size_t>(most_quads));
}

void PanelCholesky::add_panel(const SparseMatrix& lower, std::int32_t first, std::int32_t width) {
  const std::int32_t below = entries(lower, first + width - 1) - 1;
  const std::int32_t* const rows_below = rows_of(lower, first + width - 1) + 1;
  const std::int32_t quads = (width + below + kQuad - 1) / kQuad;
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
  for (std::int32_t quad = 0; quad < quads; ++quad) {
    for (std::int32_t k = 0; k < width; ++k) {
      const auto four = panel.col(k).segment<kQuad>(kQuad * quad);
      panels_.push_back({Quad::Vector{four[0], four[1], four[2], four[3]}});
    }
  }
}

void PanelCholesky::solve(PointArray& b) {
  const Eigen::Index size = b.rows();
  for (Eigen::Index i = 0; i < size; ++i) {
    double* const row = work_.data() + 2 * place_[static_cast<std::size_t>(i)];
    row[0] = b(i, 0);
    row[1] = b(i, 1);
  }
  const Quad* panel = panels_.data();
  const std::int32_t* rows = rows_.data();
  for (const Supernode& node : supernodes_) {
    forward(node, panel, rows, work_.data(), own_.data());
    panel += node.width * node.quads;
    rows += kQuad * node.quads;
  }
  for (auto node = supernodes_.rbegin(); node != supernodes_.rend(); ++node) {
    panel -= node->width * node->quads;
    rows -= kQuad * node->quads;
    backward(*node, panel, rows, work_.data(), right_.data());
  }
  for (Eigen::Index i = 0; i < size; ++i) {
    const double* const row = work_.data() + 2 * place_[static_cast<std::size_t>(i)];
    b(i, 0) = row[0];
    b(i, 1) = row[1];
  }
}

}  // namespace impact
