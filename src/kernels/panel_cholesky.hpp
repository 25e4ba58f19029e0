#pragma once

#include <Eigen/SparseCore>
#include <boost/align/aligned_allocator.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernels/kernels.hpp"
#include "kernels/lanes.hpp"
#include "lattice/lattice.hpp"

namespace impact {

/// The place of each row of a matrix when it is eliminated.
using EliminationOrder = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, std::int32_t>;

/// By approximate minimum degree (Eigen's AMD): leaves few elements in a Cholesky factor beside
/// those of the symmetric matrix.
EliminationOrder elimination_order(const Eigen::SparseMatrix<double>& matrix);

/// Solves A u = b for the same symmetric positive definite sparse A again and again, for the x and
/// y of all points at once.
///
/// Cholesky factor by Eigen, once. Its columns are then joined to supernodes (T. A.
/// Davis, Direct Methods for Sparse Linear Systems, 2006, 4.8; relaxed, with some zeros between
/// them). With L₁ the triangle on the diagonal of a supernode and L₂ the rows below it, the panel
///   Q = (L₁⁻¹; −L₂ L₁⁻¹)
/// stands for the supernode in both substitutions, each of them then a dense product without
/// divisions and with few jumps that the processor has to guess:
///   forward b₁ ← Q₁ b₁, b₂ ← b₂ + Q₂ b₁;   backward b₁ ← Qᵀ (b₁; b₂).
/// At N = 1099 on a processor with AVX2 it takes some 0.4 of the time of substitution column after
/// column, at 10⁵ 0.7.
class PanelCholesky {
 public:
  /// @throw std::runtime_error for a matrix that is not positive definite.
  explicit PanelCholesky(const Eigen::SparseMatrix<double>& matrix,
                         const Kernels& kernels = impact::kernels())
      : PanelCholesky(matrix, elimination_order(matrix), kernels) {}
  /// In this order.
  PanelCholesky(const Eigen::SparseMatrix<double>& matrix, const EliminationOrder& order,
                const Kernels& kernels = impact::kernels());

  /// Overwrites b with u.
  void solve(PointArray& b);
  /// The same in all lanes.
  void solve(LaneArray& b);

 private:
  Panels panels() const;
  void add_panel(const Eigen::SparseMatrix<double>& lower, std::int32_t first, std::int32_t width);

  const Kernels* kernels_;
  std::vector<std::int32_t> place_;  ///< of each row in the order of elimination
  std::vector<Supernode> supernodes_;
  std::vector<std::int32_t> rows_;  ///< as in Panels
  std::vector<double, boost::alignment::aligned_allocator<double, kQuad * sizeof(double)>>
      values_;                 ///< as in Panels
  std::vector<double> pairs_;  ///< of each row in the order of elimination, and 0
  std::vector<double> scratch_;
  LaneArray lane_rows_;     ///< as pairs_, in all lanes; empty until asked for
  LaneArray lane_scratch_;  ///< the same
};

}  // namespace impact
