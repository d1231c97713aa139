#!/usr/bin/env bash
# packages_in_chroot.sh SOURCE SCRATCH: makes the Debian packages from SOURCE, and installs and runs them in a Debian 12
# that has nothing else: the programs alone first, then Python's, then the libraries and a project on them. Exit 77 where
# that cannot be tried: it takes root and mmdebstrap.
set -euo pipefail
source=$1 scratch=$2
root=$scratch/root

if [ "$(id -u)" -ne 0 ] || ! command -v mmdebstrap >/dev/null || ! command -v dpkg-shlibdeps >/dev/null; then
  echo "not tried: it takes root, mmdebstrap and dpkg-dev"
  exit 77
fi
rm -rf "$scratch" && mkdir -p "$scratch"
trap 'rm -rf "$scratch"' EXIT

cmake -S "$source" --preset packages -B "$scratch/build" >/dev/null
cmake --build "$scratch/build" -j "$(nproc)" >/dev/null
(cd "$scratch/build" && cpack >/dev/null)
ls "$scratch"/build/*.deb

# The machine's own sources, so that a mirror or proxy serves here, too.
sources=(/etc/apt/sources.list.d/debian.sources)
[ -f "${sources[0]}" ] || sources=(/etc/apt/sources.list)
mmdebstrap --quiet --variant=apt --mode=root bookworm "$root" "${sources[@]}"
mkdir "$root/packages" && cp "$scratch"/build/*.deb "$root/packages/"
inside() { chroot "$root" env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 HOME=/root bash -ec "$1"; }
add() { inside "apt-get install -y -qq --no-install-recommends $1 >/dev/null"; }
inside "apt-get update -qq"

add "/packages/foamsim_*.deb"
inside "cd /tmp && foamsim run doublebubble --set n=8 --steps 3 --quiet --out run && foamsim inspect run/frames/frame_000003.ply >/dev/null"
inside "cd /tmp && foamsim run /usr/share/foamsim/scenes/demo.toml --steps 1 --quiet --out demo"
inside "cd /tmp && multitracker run enright --steps 1 --quiet --out enright && foamsim render run/frames/frame_000003.ply --size 64x48 --out pictures"

add "/packages/python3-foamsim_*.deb"
inside "python3 -c 'import foamsim; s = foamsim.Simulation(\"doublebubble\", n=8); s.step(); print(s.metrics()[\"area\"])'"

add "/packages/libfoamsim-dev_*.deb g++ cmake make"
cp -r "$source/tests/package/consumer" "$root/tmp/consumer"
inside "cmake -S /tmp/consumer -B /tmp/consumer/build >/dev/null && cmake --build /tmp/consumer/build >/dev/null"
inside "cd /tmp && consumer/build/consumer run consumer/pebble.toml --steps 2 --quiet --out pebble"

# They leave as they came.
inside "apt-get purge -y -qq foamsim libfoamsim-dev python3-foamsim >/dev/null"
inside '! command -v foamsim && [ ! -e /usr/share/foamsim ] && [ ! -e /usr/include/FoamSim ] && ! python3 -c "import foamsim" 2>/dev/null'
