#include "mechanics/kernels.hpp"

namespace impact {

bool can_run(const Kernels& kernels) {
#ifdef __x86_64__
  if (&kernels == &kAvx512Kernels) {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
  }
  if (&kernels == &kAvx2Kernels) {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  }
#endif
  return &kernels == &kPlainKernels;
}

const Kernels& kernels() {
#ifdef __x86_64__
  static const Kernels& best = can_run(kAvx512Kernels) ? kAvx512Kernels
                               : can_run(kAvx2Kernels) ? kAvx2Kernels
                                                       : kPlainKernels;
  return best;
#else
  return kPlainKernels;
#endif
}

}  // namespace impact
