#!/bin/bash
# Installs and builds what is missing, then runs all tests.
#   --strict              also the checks of the sources: compiler warnings as errors, clang-format,
#                         clang-tidy, catkin_lint, and the fuzzers for a few seconds
#   --cluster             also submit on a Slurm of this machine's own, and shards by GNU Parallel
#   --package             also the Debian package in a fresh minimal system (mmdebstrap)
#   --sanitize address    only the unit tests, with assertions, AddressSanitizer and UBSan
#   --sanitize thread     only those of several threads, with ThreadSanitizer
#   --fuzz SECONDS        only the fuzzers (libFuzzer), each for so long
#   --faults SECONDS      only harm at random to recordings, bags and results, for so long
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. launch/setup.sh

fuzzers="scene values lattice messages bag"
fuzz_packages="clang libclang-rt-dev libomp-dev"

all_tests() {
  build all -DCATKIN_ENABLE_TESTING=ON -DLATTICE_IMPACT_STRICT="$1"
  use_package
  # One more than there are processors: the tests of nodes wait most of the time.
  ctest --test-dir build --output-on-failure -j"$(($(nproc) + 1))"
}

# build_beside NAME TARGETS CMAKE_OPTION… — in build/NAME, which shares nothing with build.
build_beside() {
  local folder=build/$1 targets=$2
  shift 2
  cmake -S . -B "$folder" -DCATKIN_DEVEL_PREFIX="$PWD/$folder/devel" "$@"
  cmake --build "$folder" -j"$(nproc)" --target $targets
}

# sanitize SANITIZERS FILTER ROOM…
sanitize() {
  local sanitizers=$1 filter=$2 folder=sanitize_${1%%,*}
  shift 2
  build_beside "$folder" "${*/#/test_}" -DLATTICE_IMPACT_SANITIZE="$sanitizers" \
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="-O2 -g1"
  # A bag that cannot be written is left as it is: its destructor would end the program.
  echo leak:rosbag:: > build/leaks
  for room in "$@"; do
    LSAN_OPTIONS=suppressions=$PWD/build/leaks \
      "build/$folder/test/test_$room" --gtest_brief=1 --gtest_filter="$filter"
  done
}

fuzz() {
  install $fuzz_packages
  build_beside fuzz fuzzers -DLATTICE_IMPACT_SANITIZE=fuzzer-no-link,address,undefined \
    -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1"
  for name in $fuzzers; do
    local corpus=build/fuzz/corpus/$name seeds=test/fuzz/seeds/$name leaks=1
    # rosbag's loader of plugins leaves memory each time, and a search for leaks takes far longer than
    # reading a bag.
    [ "$name" = bag ] && leaks=0
    [ "$name" = scene ] && seeds=launch/scenes
    mkdir -p "$corpus" "build/fuzz/found"
    [ -d "$seeds" ] || seeds=
    "build/fuzz/test/fuzz_$name" -max_total_time="$1" -print_final_stats=1 -verbosity=0 \
      -print_funcs=0 -timeout=60 -detect_leaks="$leaks" \
      -artifact_prefix="build/fuzz/found/$name-" "$corpus" $seeds
  done
}

install $packages $test_packages
case "${1:-}" in
  "") all_tests OFF ;;
  --strict)
    install clang-format clang-tidy catkin-lint $fuzz_packages
    all_tests ON ;;
  --cluster)
    install slurm-wlm munge parallel
    all_tests OFF ;;
  --package)
    install mmdebstrap
    all_tests OFF ;;
  --sanitize)
    case "${2:-}" in
      address)
        sanitize address,undefined '*' lattice kernels mechanics statics solvers reference scene \
          measure theory fits run output series reproduction verification nodes ;;
      thread) sanitize thread 'ShareOut*:InParts*:SideBySide*:RunSeries*' kernels mechanics series ;;
      *) echo "--sanitize: got '${2:-}', allowed: address or thread" >&2; exit 2 ;;
    esac ;;
  --fuzz) fuzz "${2:-60}" ;;
  --faults)
    build all -DCATKIN_ENABLE_TESTING=ON
    use_package
    test/faults/faults.py --seconds "${2:-60}" ;;
  *)
    echo "got '$1', allowed: --strict, --cluster, --package, --sanitize, --fuzz or --faults" >&2
    exit 2 ;;
esac
