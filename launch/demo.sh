#!/bin/bash
# Installs and builds what is missing, then simulates, records and analyses one impact.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. launch/setup.sh

stage() {
  printf '\n%s\n' "[$1/3] $2"
}

stage 1 "Packages of Debian"
install $packages

stage 2 "Build, into build/ and devel/"
echo "  four minutes of processor time the first time, on $(nproc) processors"
# The tests stay on where test/run.sh has configured them.
first=
[ -e build/CMakeCache.txt ] || first=-DCATKIN_ENABLE_TESTING=OFF
build "simulation_node analysis_node recorder_node impact analyse_bag lattice_impact_generate_messages" $first
use_package

bag=$PWD/build/demo.bag
rm -f "$bag"
stage 3 "An impact of the default disk at 0.01 c, recorded and analysed"
echo "  roslaunch lattice_impact collision.launch bag:=$bag"
logged demo roslaunch lattice_impact collision.launch bag:="$bag"
[ -e "$bag" ] || { tail -n 40 "$log_folder/demo.log" >&2; exit 1; }
echo "  rosrun lattice_impact analyse_bag $bag"
echo
rosrun lattice_impact analyse_bag --text "$bag"
echo
echo "In a new shell, first: source $PWD/devel/setup.bash"
