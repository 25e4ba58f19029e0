#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lattice/lattice.hpp"
#include "statics/nested_dissection.hpp"

namespace impact {

/// L D Lᵀ = A of a large symmetric matrix whose rows and columns are x of all points of a plane and
/// then y of all, by the multifrontal method (I. S. Duff and J. K. Reid, ACM Trans. Math. Softw. 9,
/// 1983, 302): the points of a part of the Dissection are eliminated together, in a dense matrix of
/// those rows that they reach. There are no pivots to choose, as with Eigen's SimplicialLDLT: A may
/// have negative eigenvalues, where Cholesky factors need none.
class MultifrontalFactor {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  /// Of matrices that are stored at the places of this one, of which either triangle is given.
  /// Where it couples two points, it couples the x of one to the x of the other.
  MultifrontalFactor(const Matrix& triangle, const PointArray& position);

  /// Of A + shift 1.
  void factorise(const Matrix& triangle, double shift);
  /// A⁻¹ b; not finite where A is singular.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

 private:
  using Dense = Eigen::Map<Eigen::MatrixXd>;
  using Columns = Eigen::Map<const Eigen::MatrixXd>;
  /// An element of A: its number among the values, and where it stands in the front.
  struct Element {
    std::int32_t value;
    std::int32_t row;
    std::int32_t column;
  };
  /// Points that are eliminated together, and those after them which they reach.
  struct Front {
    std::int32_t first;                  ///< place of its first point in the order
    std::int32_t own;                    ///< points
    std::vector<std::int32_t> below;     ///< places of the points that are reached, in order
    std::vector<std::int32_t> children;  ///< fronts before it
    std::vector<Element> elements;
    std::size_t values;  ///< where its columns begin
  };

  void find_fronts(const Dissection& dissection, const Couplings& couplings);
  void find_elements(const Matrix& triangle, const std::vector<std::int32_t>& front_of);
  Eigen::MatrixXd eliminate(const Front& front, const double* values, double shift,
                            std::vector<Eigen::MatrixXd>& updates);
  static void add_update(const Front& child, const Eigen::MatrixXd& update, const Front& front,
                         Dense& columns, Eigen::MatrixXd& rest);
  static std::int32_t place_in(const Front& front, std::int32_t place);
  Columns columns_of(const Front& front) const;
  void forward(Eigen::VectorXd& b) const;
  void backward(Eigen::VectorXd& b) const;

  std::vector<std::int32_t> place_;  ///< of each point in the order of elimination
  std::vector<Front> fronts_;
  std::vector<double> values_;  ///< of each front the columns of L, below the diagonal
  Eigen::VectorXd diagonal_;    ///< D
};

}  // namespace impact
