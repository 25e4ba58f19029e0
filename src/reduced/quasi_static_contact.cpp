#include "reduced/quasi_static_contact.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace impact {
namespace {

constexpr int kMostNewtonSteps = 100;
/// Of a change of the heights, in ranges of the wall. Newton's method squares it.
constexpr double kConverged = 1e-7;

}  // namespace

QuasiStaticContact::QuasiStaticContact(PointArray arm, std::shared_ptr<Compliance> compliance,
                                       double k_a, const Repulsion& wall, double negligible_force)
    : arm_(std::move(arm)),
      compliance_(std::move(compliance)),
      k_a_(k_a),
      wall_(wall),
      highest_(wall.gap_of_force(negligible_force)),
      out_of_reach_(Eigen::ArrayXd::Zero(arm_.rows())) {}

void QuasiStaticContact::take(const Pose& pose) {
  pose_ = pose;
  let_in(pose);
  turn(pose);
  guess();
  balance();
  const Eigen::ArrayXd lever =
      std::cos(pose.angle) * contact_arm_.col(0) - std::sin(pose.angle) * contact_arm_.col(1);
  torque_ = force_.dot(lever.matrix()) + 0.5 * force_.dot(turned_a_ * force_);
}

void QuasiStaticContact::let_in(const Pose& pose) {
  const Eigen::ArrayXd height = pose.height + std::sin(pose.angle) * arm_.col(0) +
                                std::cos(pose.angle) * arm_.col(1) + out_of_reach_;
  if (height.minCoeff() >= highest_) return;
  for (Eigen::Index i = 0; i < height.size(); ++i) {
    if (height(i) >= highest_) continue;
    points_.push_back(static_cast<std::int32_t>(i));
    out_of_reach_(i) = std::numeric_limits<double>::infinity();
  }
  const PointCompliance among = compliance_->among(points_);
  even_ = 0.5 / k_a_ * (among.xx + among.yy);
  odd_ = 0.5 / k_a_ * (among.yy - among.xx);
  mixed_ = 0.5 / k_a_ * (among.xy + among.xy.transpose());
  contact_arm_ = arm_(points_, Eigen::all);
  for (Eigen::VectorXd& lift : lift_) {
    lift.conservativeResizeLike(Eigen::VectorXd::Zero(even_.rows()));
  }
}

void QuasiStaticContact::turn(const Pose& pose) {
  const double cos2 = std::cos(2.0 * pose.angle);
  const double sin2 = std::sin(2.0 * pose.angle);
  a_ = even_ + cos2 * odd_ + sin2 * mixed_;
  turned_a_ = 2.0 * (cos2 * mixed_ - sin2 * odd_);
  rigid_ = pose.height + std::sin(pose.angle) * contact_arm_.col(0) +
           std::cos(pose.angle) * contact_arm_.col(1);
}

/// The lift as a parabola of the poses.
void QuasiStaticContact::guess() {
  change_ = 3.0 * (lift_[0] - lift_[1]) + lift_[2];
  lift_[2].swap(lift_[1]);
  lift_[1].swap(lift_[0]);
  height_ = rigid_ + change_;
}

void QuasiStaticContact::balance() {
  int iterations = 0;
  while (improve() > kConverged && ++iterations < kMostNewtonSteps) {
  }
  update_forces();
  lift_[0].noalias() = a_ * force_;
}

void QuasiStaticContact::update_forces() {
  force_ = wall_.force_at(0.0) * (-wall_.a() * height_.array()).exp();
}

/// A step of Newton's method. Returns the largest change of a height, in ranges of the wall.
double QuasiStaticContact::improve() {
  update_forces();
  residual_ = height_ - rigid_;
  residual_.noalias() -= a_ * force_;
  factorise();
  change_ = -residual_;
  change_.noalias() += a_ * without_stiffness(residual_);
  height_ += change_;
  return height_.size() > 0 ? wall_.a() * change_.cwiseAbs().maxCoeff() : 0.0;
}

/// 1 + D A D.
void QuasiStaticContact::factorise() {
  root_ = (wall_.a() * force_).cwiseSqrt();
  matrix_.noalias() = root_.asDiagonal() * a_;
  matrix_ = matrix_ * root_.asDiagonal();
  matrix_.diagonal().array() += 1.0;
  factor_.compute(matrix_);
}

/// D (1 + D A D)⁻¹ D g.
Eigen::VectorXd QuasiStaticContact::without_stiffness(const Eigen::VectorXd& g) const {
  return root_.cwiseProduct(factor_.solve(root_.cwiseProduct(g)));
}

/// ḟ = −a f ẏ, ẏ = ṙ − A D (1 + D A D)⁻¹ D ṙ with ṙ the rate of the heights if the forces stayed
/// the same in the frame of the wall.
Eigen::VectorXd QuasiStaticContact::force_rate(const PoseRate& rate) const {
  const Eigen::ArrayXd lever =
      std::cos(pose_.angle) * contact_arm_.col(0) - std::sin(pose_.angle) * contact_arm_.col(1);
  Eigen::VectorXd rigid = rate.spin * (lever.matrix() + turned_a_ * force_);
  rigid.array() += rate.velocity;
  const Eigen::VectorXd rising = rigid - a_ * without_stiffness(rigid);
  return -wall_.a() * force_.cwiseProduct(rising);
}

Eigen::ArrayXd QuasiStaticContact::load() const {
  const Eigen::Index n = arm_.rows();
  Eigen::ArrayXd load = Eigen::ArrayXd::Zero(2 * n);
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const double force = force_(static_cast<Eigen::Index>(k));
    load(points_[k]) = force * std::sin(pose_.angle);
    load(n + points_[k]) = force * std::cos(pose_.angle);
  }
  return load;
}

PointArray QuasiStaticContact::displacements(const PoseRate& rate) const {
  const Eigen::Index n = arm_.rows();
  const double up_x = std::sin(pose_.angle);
  const double up_y = std::cos(pose_.angle);
  const Eigen::VectorXd growing = force_rate(rate);
  PointArray loads = PointArray::Zero(2 * n, 2);
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const std::int32_t point = points_[k];
    loads.row(point) << force_(i) * up_x, growing(i) * up_x + rate.spin * force_(i) * up_y;
    loads.row(n + point) << force_(i) * up_y, growing(i) * up_y - rate.spin * force_(i) * up_x;
  }
  compliance_->respond(loads);
  return loads / k_a_;
}

}  // namespace impact
