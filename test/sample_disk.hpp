#pragma once

#include "theory/hertz.hpp"

namespace impact {

constexpr double kModulus = 1.1;  // M c²/R²
const ElasticDisk kDisk{kModulus, 0.27};

}  // namespace impact
