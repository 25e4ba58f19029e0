#!/bin/bash
# install_test.sh BUILD_FOLDER — the installed tree works where nothing else knows of the checkout.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
DESTDIR=$folder cmake --install "$1" > "$folder/log" || { cat "$folder/log"; exit 1; }
tree=$(dirname "$(find "$folder" -name setup.bash)")

if grep -rIl "$(realpath "$1/..")" "$tree"; then
  echo "these files name the checkout"
  exit 1
fi
port=$(/usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')
env -i PATH=/usr/bin:/bin HOME="$folder" ROS_HOSTNAME=localhost ROS_MASTER_URI="http://localhost:$port" \
  bash -ec "
    cd $folder
    source $tree/setup.bash
    [ \"\$(rospack find lattice_impact)\" = $tree/share/lattice_impact ]
    roslaunch -p $port lattice_impact collision.launch N:=100 velocity:=0.05 bag:=impact.bag
    rosrun lattice_impact analyse_bag impact.bag > analysis.yaml
    rosrun lattice_impact impact collision points=100 velocity=0.05 > impact.yaml
    grep 'complete: true' analysis.yaml
  " > "$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
