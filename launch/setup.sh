# Sourced by demo.sh and test/run.sh: installs what is missing (Debian 12 packages) and builds.
# Leaves a shell in which rosrun and roslaunch find the package.

# To build and to run; the tests need the others too.
packages="g++ make cmake catkin ros-message-generation ros-std-msgs ros-geometry-msgs
  ros-visualization-msgs ros-rosgraph-msgs ros-diagnostic-msgs libstd-msgs-dev libgeometry-msgs-dev
  libvisualization-msgs-dev libros-rosgraph-msgs-dev libdiagnostic-updater-dev libroscpp-dev
  librosbag-dev python3-rosbag python3-roslaunch rosbash libboost-dev libeigen3-dev libcgal-dev
  libyaml-cpp-dev libcli11-dev libfmt-dev libgsl-dev libtbb-dev zlib1g-dev"
test_packages="libsundials-dev librostest-dev libgtest-dev libbenchmark-dev python3-rostest python3-matplotlib
  python3-numpy"

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

# install PACKAGE… — through apt, with sudo where needed; nothing when all are there.
install() {
  local there
  there=$(dpkg-query -W -f '${db:Status-Status}\n' "$@" 2>/dev/null | grep -c '^installed$') || true
  if [ "$there" -lt $# ]; then
    as_root apt-get update -q
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -yq --no-install-recommends "$@"
  fi
}

# build TARGETS CMAKE_OPTION… — configures the checkout in ./build and builds these targets.
build() {
  local targets=$1
  shift
  cmake -S . -B build "$@"
  cmake --build build -j"$(nproc)" --target $targets
}

use_package() {
  # A minimal root file system may lack the name that every roslaunch looks up.
  getent hosts localhost > /dev/null || echo 127.0.0.1 localhost | as_root tee -a /etc/hosts
  set +u
  . devel/setup.bash
  set -u
  # A python3 of the user's own, first on PATH, does not have ROS.
  export PATH=/usr/bin:$PATH
  export ROS_HOSTNAME=${ROS_HOSTNAME:-localhost}
  export ROS_MASTER_URI=${ROS_MASTER_URI:-http://localhost:11311}
}
