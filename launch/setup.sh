# Sourced by demo.sh and test/run.sh: installs what is missing (Debian 12 packages) and builds.
# Leaves a shell in which rosrun and roslaunch find the package.

# To build and to run; the tests need the others too.
packages="g++ make cmake catkin ros-message-generation ros-std-msgs ros-rosgraph-msgs
  libstd-msgs-dev libros-rosgraph-msgs-dev libroscpp-dev librosbag-dev python3-roslaunch
  rosbash libboost-dev libeigen3-dev libcgal-dev libyaml-cpp-dev libcli11-dev libfmt-dev libgsl-dev
  zlib1g-dev"
viewer_packages="libdiagnostic-updater-dev libtf2-msgs-dev libvisualization-msgs-dev"
test_packages="$viewer_packages libsundials-dev libisal-dev librostest-dev libgtest-dev
  libbenchmark-dev python3-rostest python3-rosbag python3-matplotlib python3-meshio python3-numpy"

log_folder=build/log

as_root() {
  if [ "$(id -u)" = 0 ]; then
    "$@"
  elif command -v sudo > /dev/null; then
    sudo "$@"
  else
    echo "neither root nor sudo: let an administrator run: $*" >&2
    return 1
  fi
}

# logged NAME COMMAND… — its output goes into a file; the end of it is shown when it fails.
logged() {
  local log=$log_folder/$1.log
  shift
  mkdir -p "$log_folder"
  "$@" > "$log" 2>&1 || {
    tail -n 40 "$log" >&2
    echo "failed: $* (all of it: $log)" >&2
    return 1
  }
}

# missing PACKAGE… — those that are not installed.
missing() {
  local package
  for package in "$@"; do
    dpkg-query -W -f '${db:Status-Status}\n' "$package" 2> /dev/null | grep -q '^installed$' ||
      echo "$package"
  done
}

# install PACKAGE… — through apt, with sudo where needed; nothing when all are there.
install() {
  local needed
  needed=$(missing "$@")
  [ -n "$needed" ] || { echo "  all packages are there"; return; }
  local apt_install="apt-get install -yqq --no-install-recommends"
  as_root true 2> /dev/null || { as_root $apt_install $needed; return 1; }
  logged apt_update as_root apt-get update -q
  $apt_install --print-uris $needed |
    awk '{ size += $3 } END { printf "  %d packages, %.0f MB to download: a minute or two\n", NR, size / 1e6 }'
  logged apt_install as_root env DEBIAN_FRONTEND=noninteractive $apt_install $needed
}

# build TARGETS CMAKE_OPTION… — configures the checkout in ./build and builds these targets.
build() {
  local targets=$1
  shift
  logged configure cmake -S . -B build "$@"
  logged build cmake --build build -j"$(nproc)" --target $targets
}

use_package() {
  # A minimal root file system may lack the name that every roslaunch looks up.
  getent hosts localhost > /dev/null || echo 127.0.0.1 localhost | as_root tee -a /etc/hosts > /dev/null
  set +u
  . devel/setup.bash
  set -u
  # A python3 of the user's own, first on PATH, does not have ROS.
  export PATH=/usr/bin:$PATH
  export ROS_HOSTNAME=${ROS_HOSTNAME:-localhost}
  export ROS_MASTER_URI=${ROS_MASTER_URI:-http://localhost:11311}
}
