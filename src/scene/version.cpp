#include "scene/version.hpp"

namespace impact {

const char* version() { return LATTICE_IMPACT_VERSION; }

}  // namespace impact
