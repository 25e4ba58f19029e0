#include "lattice/rectangle_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lattice/input_error.hpp"

namespace impact {
namespace {

/// The points whose coordinate `across` is `value`, in the order of the other coordinate.
std::vector<std::int32_t> side(const PointArray& points, int across, double value,
                               double tolerance) {
  std::vector<std::int32_t> found;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (std::abs(points(i, across) - value) <= tolerance) {
      found.push_back(static_cast<std::int32_t>(i));
    }
  }
  const int along = 1 - across;
  std::sort(found.begin(), found.end(),
            [&](auto a, auto b) { return points(a, along) < points(b, along); });
  return found;
}

void require_chain(const Lattice& lattice, const std::vector<std::int32_t>& top) {
  if (top.size() < 2) throw InputError("the top side has fewer than two points");
  for (std::size_t k = 1; k < top.size(); ++k) {
    const auto [first, second] = std::minmax(top[k - 1], top[k]);
    if (!std::binary_search(lattice.bonds.begin(), lattice.bonds.end(), Bond{first, second})) {
      throw InputError(fmt::format(
          "points {} and {} are neighbours on the top side but not bonded: it must be a chain of "
          "bonds",
          first + 1, second + 1));
    }
  }
}

}  // namespace

RectangleSides rectangle_sides(const Lattice& lattice) {
  constexpr double kRounding = 1e-9;
  const Eigen::Array2d low = lattice.points.colwise().minCoeff().transpose();
  const Eigen::Array2d high = lattice.points.colwise().maxCoeff().transpose();
  const double tolerance = kRounding * (high - low).maxCoeff();
  const auto find = [&](int across, double value) {
    return side(lattice.points, across, value, tolerance);
  };
  RectangleSides sides{find(0, low.x()), find(0, high.x()), find(1, low.y()), find(1, high.y())};
  require_chain(lattice, sides.top);
  return sides;
}

}  // namespace impact
