#pragma once

#include <std_msgs/ColorRGBA.h>

namespace impact {

std_msgs::ColorRGBA colour(float red, float green, float blue);

/// Colours of strain in the disk: blue (compression) over grey to red (tension), after RdBu of
/// ColorBrewer, which colour-blind people can read. `value`: -1 … 1; what lies beyond has the
/// colour of the end.
std_msgs::ColorRGBA disk_strain_colour(double value);

/// The same for an elastic wall: purple over sand to orange, after PuOr.
std_msgs::ColorRGBA wall_strain_colour(double value);

}  // namespace impact
