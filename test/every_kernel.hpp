#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "kernels/kernels.hpp"

namespace impact {

/// Tests for the kernels of every instruction set that this processor has.
class KernelTest : public testing::TestWithParam<const Kernels*> {
 protected:
  void SetUp() override {
    if (!can_run(*GetParam())) GTEST_SKIP() << "not on this processor";
  }
};

inline auto all_kernels() {
  return testing::Values(&kPlainKernels, &kAvx2Kernels, &kAvx512Kernels);
}

/// Letters and digits only.
inline std::string kernel_name(const testing::TestParamInfo<const Kernels*>& info) {
  std::string name = info.param->name;
  name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
  return name;
}

}  // namespace impact
