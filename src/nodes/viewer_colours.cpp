#include "nodes/viewer_colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace impact {
namespace {

using Colour = std::array<float, 3>;
using Anchors = std::array<Colour, 7>;  // evenly from -1 to 1

// The middle is darker than ColorBrewer's, which would vanish on a light background.
constexpr Anchors kDiskAnchors{{{0.02F, 0.19F, 0.38F},
                                {0.13F, 0.40F, 0.67F},
                                {0.40F, 0.62F, 0.80F},
                                {0.76F, 0.76F, 0.76F},
                                {0.90F, 0.55F, 0.45F},
                                {0.75F, 0.15F, 0.20F},
                                {0.40F, 0.00F, 0.12F}}};
constexpr Anchors kWallAnchors{{{0.18F, 0.00F, 0.29F},
                                {0.33F, 0.15F, 0.53F},
                                {0.58F, 0.51F, 0.71F},
                                {0.82F, 0.78F, 0.68F},
                                {0.91F, 0.68F, 0.36F},
                                {0.75F, 0.42F, 0.05F},
                                {0.50F, 0.23F, 0.03F}}};

std_msgs::ColorRGBA between(const Anchors& anchors, double value) {
  constexpr double kLast = static_cast<double>(std::tuple_size_v<Anchors>) - 1.0;
  const double place = 0.5 * kLast * (std::clamp(value, -1.0, 1.0) + 1.0);
  const double below = std::min(std::floor(place), kLast - 1.0);
  const auto part = static_cast<float>(place - below);
  const auto k = static_cast<std::size_t>(below);
  const auto mixed = [&](std::size_t channel) {
    return (1.0F - part) * anchors[k][channel] + part * anchors[k + 1][channel];
  };
  return colour(mixed(0), mixed(1), mixed(2));
}

}  // namespace

std_msgs::ColorRGBA colour(float red, float green, float blue) {
  std_msgs::ColorRGBA result;
  result.r = red;
  result.g = green;
  result.b = blue;
  result.a = 1.0F;
  return result;
}

std_msgs::ColorRGBA disk_strain_colour(double value) { return between(kDiskAnchors, value); }

std_msgs::ColorRGBA wall_strain_colour(double value) { return between(kWallAnchors, value); }

}  // namespace impact
