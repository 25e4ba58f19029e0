#!/bin/bash
# deb_test.sh BUILD_FOLDER — installs the Debian package in a fresh minimal Debian 12, with nothing but
# what it depends on, and simulates, records and analyses an impact there.
set -euo pipefail
cd "$1"

command -v mmdebstrap > /dev/null || { echo "SKIPPED: needs mmdebstrap, as test/run.sh --package installs it"; exit 77; }

# Not in the build folder: roslaunch would find the copies of the launch files there.
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cpack -B "$folder" > "$folder/log" || { cat "$folder/log"; exit 1; }
cd "$folder"
deb=$(echo ros-lattice-impact_*_*.deb)

# All in one root that is thrown away.
mmdebstrap --variant=apt --format=null --quiet \
  --aptopt='APT::Install-Recommends "false"' \
  --customize-hook="copy-in $deb /tmp" \
  --customize-hook='echo 127.0.0.1 localhost >> "$1/etc/hosts"' \
  --customize-hook="chroot \"\$1\" apt-get install -yqq --no-install-recommends /tmp/$deb" \
  --customize-hook='chroot "$1" sh -c "command -v g++ && echo a compiler came along && exit 1; true"' \
  --customize-hook='chroot "$1" env HOME=/root ROS_HOSTNAME=localhost roslaunch lattice_impact collision.launch N:=300 bag:=/tmp/impact.bag' \
  --customize-hook='chroot "$1" rosrun lattice_impact viewer_node --help' \
  --customize-hook='chroot "$1" rosrun lattice_impact analyse_bag /tmp/impact.bag > '"$PWD"'/analysis.txt' \
  bookworm > log 2>&1 || { tail -n 60 log; exit 1; }
grep -q "complete: true" analysis.txt
