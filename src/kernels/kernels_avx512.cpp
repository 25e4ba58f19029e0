#include "kernels/kernels.inc"

#ifdef __AVX512F__
namespace impact {

const Kernels kAvx512Kernels = kernels_named("AVX-512");

}  // namespace impact
#endif
