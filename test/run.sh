#!/bin/bash
# Installs and builds what is missing, then runs all tests. With --strict also the checks of the
# sources: compiler warnings as errors, clang-format, clang-tidy and catkin_lint.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. launch/setup.sh

strict=OFF
if [ "${1:-}" = --strict ]; then
  strict=ON
  install clang-format clang-tidy catkin-lint
fi
install $packages
build -DLATTICE_IMPACT_STRICT=$strict
use_package
ctest --test-dir build --output-on-failure -j"$(nproc)"
