#include "kernels/kernels.inc"

namespace impact {

const Kernels kPlainKernels = kernels_named("plain");

}  // namespace impact
