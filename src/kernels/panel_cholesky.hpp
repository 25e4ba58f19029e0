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

/// How the two columns of a PointArray are right-hand sides of a linear system.
enum class Sides {
  kOne,  ///< of one, twice as large: x of all points and then y of all points
  kTwo   ///< each of the same
};

/// Solves A u = b for the same symmetric positive definite sparse A again and again.
///
/// Cholesky factor by Eigen (AMD ordering), once. Its columns are then joined to supernodes (T. A.
/// Davis, Direct Methods for Sparse Linear Systems, 2006, 4.8; relaxed, with some zeros between
/// them). With L₁ the triangle on the diagonal of a supernode and L₂ the rows below it, the panel
///   Q = (L₁⁻¹; −L₂ L₁⁻¹)
/// stands for the supernode in both substitutions, each of them then a dense product without
/// divisions and with few jumps that the processor has to guess:
///   forward b₁ ← Q₁ b₁, b₂ ← b₂ + Q₂ b₁;   backward b₁ ← Qᵀ (b₁; b₂).
/// At N = 1099 on a processor with AVX2 it takes 0.42 of the time of substitution column after
/// column, at 10⁵ 0.7.
class PanelCholesky {
 public:
  /// @throw std::runtime_error for a matrix that is not positive definite.
  explicit PanelCholesky(const Eigen::SparseMatrix<double>& matrix,
                         const Kernels& kernels = impact::kernels(), Sides sides = Sides::kTwo);

  /// Overwrites b with u.
  void solve(PointArray& b);
  /// The same of two right-hand sides, in all lanes.
  void solve(LaneArray& b);

 private:
  Panels panels() const;
  void add_panel(const Eigen::SparseMatrix<double>& lower, std::int32_t first, std::int32_t width);
  /// Numbers of a row.
  int width() const { return sides_ == Sides::kTwo ? 2 : 1; }
  /// Where a coordinate (0: x, 1: y) of one of so many points is in the order of elimination.
  std::ptrdiff_t place(Eigen::Index point, int axis, Eigen::Index points) const {
    return sides_ == Sides::kTwo
               ? std::ptrdiff_t{2} * place_[static_cast<std::size_t>(point)] + axis
               : place_[static_cast<std::size_t>(axis * points + point)];
  }

  const Kernels* kernels_;
  Sides sides_;
  std::vector<std::int32_t> place_;  ///< of each row in the order of elimination
  std::vector<Supernode> supernodes_;
  std::vector<std::int32_t> rows_;  ///< as in Panels
  std::vector<double, boost::alignment::aligned_allocator<double, kQuad * sizeof(double)>>
      values_;                   ///< as in Panels
  std::vector<double> numbers_;  ///< of each row in the order of elimination, and 0
  std::vector<double> scratch_;
  LaneArray lane_rows_;     ///< as numbers_, in all lanes; empty until asked for
  LaneArray lane_scratch_;  ///< the same
};

}  // namespace impact
