#pragma once

namespace impact {

/// An isotropic elastic disk in plane stress, radius 1 R, thickness 1. Moduli in M c²/R² (force per
/// length in two dimensions).
struct ElasticDisk {
  double young_modulus = 0.0;  ///< E
  double poisson_ratio = 0.0;  ///< ν
};

/// The 2D Hertz law of eq. (2): compression ξ (R) under the force P (M c²/R),
///   ξ = b P/(πE) {ln(4πE R/(b P)) − 1 − ν};
/// b = 1 − ν² in the paper's theory, a fitted number in its figure 2.
double hertz_compression(const ElasticDisk& disk, double b, double force);

/// Compression of a plane-stress disk that a uniform body force holds on a rigid plane, to leading
/// order in P/(πE): ξ = P/(πE) [ln(πE R/P) − (1 + ν)/4], the height of the centre of mass.
double inertial_load_compression(const ElasticDisk& disk, double force);

/// Half width of the contact under the force P: a² = 4 P R/(πE) (K. L. Johnson, Contact Mechanics,
/// 1985, eq. 4.43).
double contact_half_width(const ElasticDisk& disk, double force);

/// Hertz's pressure at the distance x from the middle of the contact, the half-ellipse
/// 2P/(πa) √(1 − x²/a²) (ibid., eqs. 4.44 and 4.45); 0 outside.
double contact_pressure(const ElasticDisk& disk, double force, double x);

}  // namespace impact
