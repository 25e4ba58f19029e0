#include "mechanics/kernel_body.hpp"

namespace impact {

const Kernels kPlainKernels = kernels_named("plain");

}  // namespace impact
