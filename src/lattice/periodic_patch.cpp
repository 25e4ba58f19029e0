#include "lattice/periodic_patch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "lattice/input_error.hpp"
#include "lattice/triangulation.hpp"

namespace impact {
namespace {

struct Image {
  int x;  // in widths
  int y;  // in heights
};

/// The patch itself, then four images, then the four opposite to them.
constexpr std::array<Image, 9> kImages{
    {{0, 0}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}}};
constexpr std::int32_t kImagesOnOneSide = 5;

PointArray tiled(const PointArray& points, double width, double height) {
  const Eigen::Index n = points.rows();
  PointArray tiles(n * static_cast<Eigen::Index>(kImages.size()), 2);
  for (std::size_t k = 0; k < kImages.size(); ++k) {
    auto tile = tiles.middleRows(n * static_cast<Eigen::Index>(k), n);
    tile.col(0) = points.col(0) + width * kImages[k].x;
    tile.col(1) = points.col(1) + height * kImages[k].y;
  }
  return tiles;
}

void require_short_bonds(const PeriodicPatch& patch) {
  if ((patch.bond_vectors.col(0).abs() < patch.width / 2.0).all() &&
      (patch.bond_vectors.col(1).abs() < patch.height / 2.0).all()) {
    return;
  }
  throw InputError(fmt::format(
      "{} points are too few for a periodic patch of {} by {} R: a bond spans half of it",
      patch.points.rows(), patch.width, patch.height));
}

}  // namespace

PeriodicPatch triangulated_patch(PointArray points, double width, double height) {
  const auto n = static_cast<std::int32_t>(points.rows());
  const PointArray tiles = tiled(points, width, height);
  std::vector<Bond> bonds = delaunay_bonds(tiles);
  // Of a bond that crosses a side and its repetition on the opposite side one is kept.
  bonds.erase(std::remove_if(bonds.begin(), bonds.end(),
                             [n](const Bond& bond) {
                               return bond.first >= n || bond.second >= kImagesOnOneSide * n;
                             }),
              bonds.end());

  PointArray vectors(static_cast<Eigen::Index>(bonds.size()), 2);
  for (std::size_t k = 0; k < bonds.size(); ++k) {
    const auto [first, second] = bonds[k];
    const std::int32_t original = second % n;
    const double sign = first < original ? 1.0 : -1.0;
    vectors.row(static_cast<Eigen::Index>(k)) = sign * (tiles.row(first) - tiles.row(second));
    bonds[k] = {std::min(first, original), std::max(first, original)};
  }
  PeriodicPatch patch{std::move(points), std::move(bonds), std::move(vectors), width, height};
  require_short_bonds(patch);
  return patch;
}

PeriodicPatch random_patch(int points, Placement placement, double width, double height,
                           std::uint64_t seed) {
  return triangulated_patch(place_in_periodic_rectangle(points, placement, width, height, seed),
                            width, height);
}

}  // namespace impact
