#!/bin/bash
# Installs and builds what is missing, then simulates, records and analyses one impact.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. launch/setup.sh

install $packages
# The tests stay on where test/run.sh has configured them.
first=
[ -e build/CMakeCache.txt ] || first=-DCATKIN_ENABLE_TESTING=OFF
build "simulation_node analysis_node recorder_node impact analyse_bag lattice_impact_generate_messages" $first
use_package

bag=$PWD/build/demo.bag
log=$PWD/build/demo.log
rm -f "$bag"
echo
echo "roslaunch lattice_impact collision.launch bag:=$bag"
roslaunch lattice_impact collision.launch bag:="$bag" > "$log" 2>&1 || { cat "$log"; exit 1; }

echo "The impact of the default disk at 0.01 c; forces in M c²/R, times in R/c:"
rosrun lattice_impact analyse_bag "$bag" || { cat "$log"; exit 1; }
echo "Recorded in $bag"
