#pragma once
#include "mechanics/velocity_verlet.hpp"
namespace impact {
struct Scales { double length; double velocity; };
struct Bdf : VelocityVerlet { Bdf(double, const Scales&) {} };
}
