#include "kernels/kernels.hpp"

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

namespace {

const Kernels* best_kernels() {
#ifdef __x86_64__
  if (can_run(kAvx512Kernels)) return &kAvx512Kernels;
  if (can_run(kAvx2Kernels)) return &kAvx2Kernels;
#endif
  return &kPlainKernels;
}

const Kernels*& chosen_kernels() {
  static const Kernels* chosen = best_kernels();
  return chosen;
}

}  // namespace

const Kernels& kernels() { return *chosen_kernels(); }

void choose_kernels(const Kernels& kernels) { chosen_kernels() = &kernels; }

}  // namespace impact
