#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lattice/lattice.hpp"

namespace impact {

/// Solves A u = b for the same symmetric positive definite sparse A again and again, always for two
/// right-hand sides, as velocities have two components.
///
/// Cholesky factor by Eigen (AMD ordering), once. Its columns are then joined to supernodes (T. A.
/// Davis, Direct Methods for Sparse Linear Systems, 2006, 4.8; relaxed, with some zeros between
/// them). With L₁ the triangle on the diagonal of a supernode and L₂ the rows below it, the panel
///   Q = (L₁⁻¹; −L₂ L₁⁻¹)
/// stands for the supernode in both substitutions, each of them then a dense product without
/// divisions and with few jumps that the processor has to guess:
///   forward b₁ ← Q₁ b₁, b₂ ← b₂ + Q₂ b₁;   backward b₁ ← Qᵀ (b₁; b₂).
/// At N = 1099 on a processor with AVX2 it takes 0.43 of the time of substitution column after
/// column, at 10⁵ 0.7.
class PanelCholesky {
 public:
  explicit PanelCholesky(const Eigen::SparseMatrix<double>& matrix);

  /// Overwrites both columns of b with those of u.
  void solve(PointArray& b);

  /// Consecutive columns of L, of about the same structure.
  struct Supernode {
    std::int32_t first;  ///< column
    std::int32_t width;
    std::int32_t quads;  ///< rows of the panel/4, the last ones filled up with zeros
  };
  /// Four rows of a column of a panel, or of a right-hand side.
  struct alignas(32) Quad {
    using Vector = double __attribute__((vector_size(32)));
    Vector of;
  };

 private:
  void add_panel(const Eigen::SparseMatrix<double>& lower, std::int32_t first, std::int32_t width);

  std::vector<std::int32_t> place_;  ///< of each row in the order of elimination
  std::vector<Supernode> supernodes_;
  std::vector<std::int32_t> rows_;  ///< of all panels; N where there is none
  std::vector<Quad> panels_;        ///< of each supernode: quad after quad, its columns together
  std::vector<double> work_;        ///< x and y of each row in the order of elimination
  std::vector<double> own_;         ///< of the columns of one supernode
  std::vector<Quad> right_;         ///< of the rows of one supernode, x and y of each quad
};

}  // namespace impact
