#!/bin/bash
# Installs and builds what is missing, then simulates, records and analyses one impact.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. launch/setup.sh

install $packages
build
use_package

bag=$PWD/build/demo.bag
rm -f "$bag"
roslaunch lattice_impact collision.launch bag:="$bag"

echo
echo "What the bag holds, and what it says of the impact:"
rosrun lattice_impact analyse_bag "$bag"
echo "Recorded in $bag"
