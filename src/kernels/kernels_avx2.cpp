#include "kernels/kernels.inc"

#ifdef __AVX2__
namespace impact {

const Kernels kAvx2Kernels = kernels_named("AVX2");

}  // namespace impact
#endif
