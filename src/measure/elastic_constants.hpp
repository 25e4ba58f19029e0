#pragma once

#include <Eigen/Core>

#include "lattice/lattice.hpp"
#include "lattice/periodic_patch.hpp"
#include "mechanics/bond_forces.hpp"

namespace impact {

/// Of an isotropic sheet in plane stress.
struct ElasticConstants {
  double young_modulus;  ///< E, M c²/R²
  double poisson_ratio;  ///< ν
};

/// The stiffness of an endless lattice of linear springs k_a (M c²/R²) in Voigt's notation:
/// (σ_xx, σ_yy, σ_xy) = C (ε_xx, ε_yy, 2 ε_xy). Each macroscopic strain elongates the bonds; the
/// points then move from their affine places, periodically, until all forces vanish (sparse LDLᵀ,
/// one point tied): A. Lemaître and C. Maloney, J. Stat. Phys. 123 (2006) 415.
/// @throw std::runtime_error when the springs do not hold the lattice in shape.
Eigen::Matrix3d periodic_stiffness(const PeriodicPatch& patch, double k_a);

/// Of the isotropic sheet whose stiffness is the average of this one over all orientations:
///   K = (C₁₁ + C₂₂ + 2 C₁₂)/4,  G = (C₁₁ + C₂₂ − 2 C₁₂ + 4 C₆₆)/8,
///   E = 4 K G/(K + G),  ν = (K − G)/(K + G).
ElasticConstants isotropic_average(const Eigen::Matrix3d& stiffness);

/// |C − C_iso|/|C_iso| with C_iso the average over all orientations and |C|² = Σ C_ijkl²: 0 for an
/// isotropic sheet, the same in any frame. A random patch of N points has about 0.6/√N.
double anisotropy(const Eigen::Matrix3d& stiffness);

/// The rectangle |x| ≤ half_width, |y| ≤ half_height (R) about the middle of the reference lattice,
/// that is the middle of its bounding box. It must not reach beyond the lattice.
struct MiddleRegion {
  double half_width;
  double half_height;
};

/// Mean stress (first Piola–Kirchhoff, M c²/R²) in the region, the virial of its bonds:
///   P = (1/area) Σ w T n ⊗ d:
/// T the tension of a bond, n its present direction, d its vector in the reference configuration
/// and w the fraction of d that lies in the region. This is exactly the mean of a stress that is
/// concentrated on the bonds: in equilibrium P x̂ over the whole height of a body with free sides is
/// the pull on its ends over its height, wherever the region ends.
Eigen::Matrix2d mean_stress(const Lattice& lattice, const PointArray& position, const BondLaw& law,
                            const MiddleRegion& region);

/// Mean deformation gradient ∂r/∂r_reference of the region: the affine field that fits its points
/// best (least squares). NaN when they are fewer than three.
Eigen::Matrix2d mean_deformation(const Lattice& lattice, const PointArray& position,
                                 const MiddleRegion& region);

/// E and ν from the mean stress and strain of the region of a body that is stretched along x and at
/// rest (the damping of the law is not used):
///   ν = (σ_xx ε_yy − σ_yy ε_xx)/(σ_yy ε_yy − σ_xx ε_xx),  E = (σ_xx − ν σ_yy)/ε_xx.
/// σ_yy need not vanish. Strain and stress are taken in the frame that turns with the body, so a
/// rigid motion changes nothing. Linear elasticity: the error is of the order of the strain.
/// On random blue-noise rectangles of 1099 points with clamped ends the affine fit has a bias of at
/// most 0.5 % of E and scatters as little as the mean strain of the triangles: what scatters is the
/// piece's own stiffness along x, by about 0.7/√(points in the region) of E (see anisotropy()).
ElasticConstants stretched_constants(const Lattice& lattice, const PointArray& position,
                                     const BondLaw& law, const MiddleRegion& region);

}  // namespace impact
