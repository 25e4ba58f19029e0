#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "kernels/padded_matrix.hpp"
#include "lattice/lattice.hpp"
#include "statics/compliance.hpp"

namespace impact {

/// Displacements in which a lattice of mass 1 M answers slow forces of a wall below it, and what
/// the linear lattice comes to on them (Galerkin projection). With S the shapes in columns,
/// Sᵀ m S = 1, the stiffness Sᵀ K S is diagonal; the damping Sᵀ L S is not. Column 0 is the
/// rotation about the centre of mass, with no stiffness; all others are neither shifts nor
/// rotations. Being a projection, it keeps what the lattice has: symmetry, energy and passivity.
///
/// The shapes span, with B a unit force along y on each point that can come into contact and K⁺ as
/// in Compliance,
/// - what those forces do if they grow slowly, K⁺ B, so that contacts are as soft as they are;
/// - how the bulk swings, (K⁺)ʲ K⁺ F, of a few distributions F of the force over the contact, as
///   moment matching by Krylov vectors has it (Z. Bai, Appl. Numer. Math. 43 (2002) 9);
/// - what the damping of a displacement does, K⁺ L K⁺ B and K⁺ L K⁺ L K⁺ B.
/// Of a point that lies higher than the disk may be pressed in, a shape counts with the part of the
/// force that reaches it, and what adds less than a small part of the largest is left out.
struct BulkModes {
  PointArray arm;                    ///< points about the centre of mass, R
  double inertia = 0.0;              ///< M R²
  std::vector<std::int32_t> points;  ///< that can come into contact, the lowest first
  Eigen::MatrixXd shapes;            ///< rows: along x of all points, then along y; M^(−1/2)
  PaddedMatrix onto_points;          ///< shapes
  PaddedMatrix onto_modes;           ///< transposed
  Eigen::VectorXd stiffness;         ///< of each shape: frequency² for k_a = 1 M c²/R²
  Eigen::MatrixXd damping;           ///< for η = 1 M c/R
  Eigen::MatrixXd turning;           ///< of shapes by a right angle: Sᵀ m J S
  Eigen::VectorXd reach;             ///< Sᵀ m s, M^(1/2) R
};

/// Of a lattice above a wall of the range 1/a (R).
BulkModes bulk_modes(const Lattice& lattice, Compliance& compliance, double a);

/// The modes of one lattice, made when somebody asks for them; kept for the latest wall.
class BulkModesOnDemand {
 public:
  std::shared_ptr<const BulkModes> of(const Lattice& lattice, ComplianceOnDemand& compliance,
                                      double a);

 private:
  std::mutex mutex_;
  double a_ = 0.0;
  std::shared_ptr<const BulkModes> modes_;
};

}  // namespace impact
