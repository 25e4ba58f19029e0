#pragma once

#include <Eigen/Core>

#include "kernels/lanes.hpp"

namespace impact {

/// A number of each of kLanes runs as one scalar, for algorithms that are templates over it: they
/// then do in every lane what they do with a double. It is equal to another, or not more, if it is
/// so in all lanes.
class LaneScalar {
 public:
  LaneScalar() = default;
  explicit LaneScalar(double number) : numbers_(LaneNumbers::Constant(number)) {}

  LaneScalar& operator+=(const LaneScalar& other) { return set(numbers_ + other.numbers_); }
  LaneScalar& operator-=(const LaneScalar& other) { return set(numbers_ - other.numbers_); }
  LaneScalar& operator*=(const LaneScalar& other) { return set(numbers_ * other.numbers_); }
  LaneScalar& operator/=(const LaneScalar& other) { return set(numbers_ / other.numbers_); }

  friend LaneScalar operator+(LaneScalar a, const LaneScalar& b) { return a += b; }
  friend LaneScalar operator-(LaneScalar a, const LaneScalar& b) { return a -= b; }
  friend LaneScalar operator*(LaneScalar a, const LaneScalar& b) { return a *= b; }
  friend LaneScalar operator/(LaneScalar a, const LaneScalar& b) { return a /= b; }
  friend bool operator==(const LaneScalar& a, const LaneScalar& b) {
    return (a.numbers_ == b.numbers_).all();
  }
  friend bool operator!=(const LaneScalar& a, const LaneScalar& b) { return !(a == b); }
  friend bool operator<=(const LaneScalar& a, const LaneScalar& b) {
    return (a.numbers_ <= b.numbers_).all();
  }
  friend LaneScalar sqrt(LaneScalar a) { return a.set(a.numbers_.sqrt()); }

  double& operator[](int lane) { return numbers_[lane]; }
  double operator[](int lane) const { return numbers_[lane]; }

 private:
  template <class Expression>
  LaneScalar& set(const Expression& numbers) {
    numbers_ = numbers;
    return *this;
  }

  LaneNumbers numbers_;
};

}  // namespace impact

namespace Eigen {

template <>
struct NumTraits<impact::LaneScalar> : GenericNumTraits<impact::LaneScalar> {
  using Real = impact::LaneScalar;
  using NonInteger = impact::LaneScalar;
  using Nested = impact::LaneScalar;
  using Literal = double;
};

}  // namespace Eigen
