#include "statics/compliance.hpp"

#include <cstddef>

#include "mechanics/body_motion.hpp"
#include "statics/tied_stiffness.hpp"

namespace impact {
namespace {

Eigen::ArrayXd unit_rotation(const PointArray& points) {
  const PointArray arm = about_the_centre(points);
  Eigen::ArrayXd turn(2 * arm.rows());
  turn << -arm.col(1), arm.col(0);
  return turn / turn.matrix().norm();
}

}  // namespace

Compliance::Compliance(const Lattice& lattice)
    : turn_(unit_rotation(lattice.points)),
      factor_(tied_stiffness(lattice)),
      place_(static_cast<std::size_t>(lattice.points.rows()), -1) {}

PointCompliance Compliance::among(const std::vector<std::int32_t>& points) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const std::int32_t point : points) {
    if (place_[static_cast<std::size_t>(point)] < 0) compute(point);
  }
  const auto size = static_cast<Eigen::Index>(points.size());
  PointCompliance compliance{Eigen::MatrixXd(size, size), Eigen::MatrixXd(size, size),
                             Eigen::MatrixXd(size, size)};
  const auto place_of = [&](Eigen::Index index) {
    const std::int32_t point = points[static_cast<std::size_t>(index)];
    return static_cast<std::size_t>(place_[static_cast<std::size_t>(point)]);
  };
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) {
      const std::size_t row = place_of(i);
      const std::size_t column = place_of(j);
      const bool is_kept = column <= row;
      const auto& block = is_kept ? blocks_[row][column] : blocks_[column][row];
      compliance.xx(i, j) = block[0];
      compliance.xy(i, j) = is_kept ? block[1] : block[2];
      compliance.yy(i, j) = block[3];
    }
  }
  return compliance;
}

void Compliance::respond(PointArray& loads) {
  const std::lock_guard<std::mutex> lock(mutex_);
  solve(loads);
}

/// The matrix is symmetric, so that the response of the points computed before says how this one
/// answers to them.
void Compliance::compute(std::int32_t point) {
  const auto n = static_cast<Eigen::Index>(place_.size());
  place_[static_cast<std::size_t>(point)] = static_cast<std::int32_t>(computed_.size());
  computed_.push_back(point);
  PointArray response = PointArray::Zero(2 * n, 2);
  response(point, 0) = 1.0;
  response(n + point, 1) = 1.0;
  solve(response);
  blocks_.emplace_back();
  for (const std::int32_t other : computed_) {
    blocks_.back().push_back(
        {response(other, 0), response(n + other, 0), response(other, 1), response(n + other, 1)});
  }
}

void Compliance::balance(PointArray& columns) const {
  const Eigen::Index n = turn_.size() / 2;
  for (int k = 0; k < 2; ++k) {
    auto column = columns.col(k);
    column.head(n) -= column.head(n).mean();
    column.tail(n) -= column.tail(n).mean();
    column -= (turn_ * column).sum() * turn_;
  }
}

void Compliance::solve(PointArray& loads) {
  balance(loads);
  factor_.solve(loads);
  balance(loads);
}

}  // namespace impact
