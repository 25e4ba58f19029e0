#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "lattice/lattice.hpp"
#include "mechanics/contact.hpp"
#include "statics/compliance.hpp"

namespace impact {

/// Where a body is as a whole above a wall at y = 0.
struct Pose {
  double height = 0.0;  ///< of its centre of mass, R
  double angle = 0.0;   ///< by which it is turned, rad, counter-clockwise
};

/// How a pose changes.
struct PoseRate {
  double velocity = 0.0;  ///< upwards, c
  double spin = 0.0;      ///< c/R
};

/// An elastic body on the potential wall, so slow that it is at rest in itself: its points lie
/// where bonds and wall balance, the bulk linear in a frame that turns with the body.
///
/// With s the points about the centre of mass, n = (sin φ, cos φ) the upward normal in the frame of
/// the body and G = K⁺/k_a its compliance (see Compliance), the points in contact have the heights
///   y = Y + n·s + A f,  A = nᵀ G n,  f = a V₀ exp(−a y),
/// solved for y by Newton's method; with D² = diag(a f) each step is
///   δ = −g + A D (1 + D A D)⁻¹ D g,  g = y − Y − n·s − A f,
/// from which heights can only be approached. The energy U(Y, φ) = ½ fᵀ A f + Σ f/a is stationary
/// against y, so that the force along y is −∂U/∂Y = Σ f and the torque
///   −∂U/∂φ = Σ f n′·s + ½ fᵀ (dA/dφ) f,  n′ = dn/dφ.
///
/// Points come in when the wall would push them by more than a negligible force where they would
/// be without the elastic displacement, which is upwards near the contact; until then it does not
/// push them at all.
class QuasiStaticContact {
 public:
  /// `arm`: the points about their centre of mass, one row each (R). `negligible_force` on a point
  /// (M c²/R).
  QuasiStaticContact(PointArray arm, std::shared_ptr<Compliance> compliance, double k_a,
                     const Repulsion& wall, double negligible_force);

  /// Finds the balance at this pose. Poses should follow each other closely: the search begins
  /// where the last three lead.
  void take(const Pose& pose);

  // Of the pose taken last.
  double force() const { return force_.sum(); }  ///< along y, M c²/R
  double torque() const { return torque_; }      ///< about the centre of mass, M c²
  double largest_force() const { return force_.size() > 0 ? force_.maxCoeff() : 0.0; }
  double bond_energy() const { return 0.5 * force_.dot(lift_[0]); }      ///< ½ fᵀ A f, M c²
  double energy() const { return bond_energy() + force() / wall_.a(); }  ///< and of the wall
  /// The force on each point in the frame of the body, along x of all points, then along y.
  Eigen::ArrayXd load() const;
  /// The points in contact, in the order in which they came in.
  const std::vector<std::int32_t>& points() const { return points_; }
  /// On each of them, along y, M c²/R.
  const Eigen::VectorXd& forces() const { return force_; }

  /// Of all points in the frame of the body, along x and then along y: in the first column the
  /// displacements (R), in the second their rates (c).
  PointArray displacements(const PoseRate& rate) const;

  const PointArray& arm() const { return arm_; }
  Compliance& compliance() const { return *compliance_; }  ///< for k_a = 1
  double k_a() const { return k_a_; }                      ///< M c²/R²

 private:
  void let_in(const Pose& pose);
  void turn(const Pose& pose);
  void guess();
  void balance();
  double improve();
  void update_forces();
  void factorise();
  Eigen::VectorXd without_stiffness(const Eigen::VectorXd& g) const;
  Eigen::VectorXd force_rate(const PoseRate& rate) const;

  PointArray arm_;
  std::shared_ptr<Compliance> compliance_;
  double k_a_;
  Repulsion wall_;
  double highest_;  ///< rigid height from which on a point is not in contact

  Pose pose_;
  std::vector<std::int32_t> points_;
  Eigen::ArrayXd out_of_reach_;  ///< 0; infinity for the points in contact
  PointArray contact_arm_;       ///< rows of arm_
  Eigen::MatrixXd even_;         ///< (Gxx + Gyy)/2
  Eigen::MatrixXd odd_;          ///< (Gyy − Gxx)/2
  Eigen::MatrixXd mixed_;        ///< (Gxy + Gyx)/2
  Eigen::MatrixXd a_;
  Eigen::MatrixXd turned_a_;  ///< dA/dφ
  Eigen::VectorXd rigid_;     ///< Y + n·s
  Eigen::VectorXd height_;
  std::array<Eigen::VectorXd, 3> lift_;  ///< A f, of the last three poses, the latest first
  Eigen::VectorXd force_;
  double torque_ = 0.0;

  Eigen::VectorXd root_;    ///< D
  Eigen::MatrixXd matrix_;  ///< 1 + D A D
  Eigen::LLT<Eigen::MatrixXd> factor_;
  Eigen::VectorXd residual_;
  Eigen::VectorXd change_;
};

}  // namespace impact
