#!/bin/bash
# Installs and builds what is missing, then simulates, records and analyses one impact.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. launch/setup.sh

install $packages
build
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
