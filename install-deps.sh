#!/usr/bin/env bash
# Installs the Debian 12 packages that FoamSim is built, tested and plotted with; does nothing when all are there. --to-run:
# only those that building the programs, running them and plotting take.
set -euo pipefail

packages=(
  # compiler and build
  g++ cmake ninja-build git
  # libraries
  libeigen3-dev libsuitesparse-dev libboost-dev libtbb-dev libhwy-dev libcli11-dev libtomlplusplus-dev
  nlohmann-json3-dev libembree-dev libpng-dev zlib1g-dev voro++-dev
  # several machines
  libopenmpi-dev openmpi-bin
  # tests and benchmarks
  libgtest-dev librapidcheck-dev libbenchmark-dev
  # import foamsim
  pybind11-dev python3-dev python3-numpy
  # plots
  python3-matplotlib
  # films
  ffmpeg
  # the viewer in a browser
  nodejs
)
test_packages=(
  # import foamsim
  python3-pytest
  # read what is written for ParaView and other programs
  python3-vtk9 python3-meshio
  # imports frames
  blender
  # shows the viewer
  chromium
  # makes the runs of a sweep
  parallel
  # takes our completion
  zsh
  # Surface Evolver (3 MB), whose equilibria are drawn beside ours, and which reads our surfaces
  evolver-nox
  # style, the second compiler and its sanitizers, reference pages
  clang-format clang-tidy clang libclang-rt-dev doxygen
  # the documentation as a site
  mkdocs mkdocs-material
  # Debian packages, and a system to try them in
  dpkg-dev mmdebstrap
)
case "${1:-}" in
  --to-run) ;;
  "") packages+=("${test_packages[@]}") ;;
  *) echo "install-deps.sh: '$1' is no option; --to-run is one" >&2; exit 2 ;;
esac

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
  [ "$status" = "install ok installed" ] || missing+=("$package")
done
# npm belongs to nodejs in some packages, which then conflict with Debian's own.
command -v npm >/dev/null || missing+=(npm)

# The viewer's packages, as web/package-lock.json has them; without a network the viewer is left out.
install_viewer_packages() {
  local web
  web=$(dirname "$0")/web
  [ "$web/node_modules/.package-lock.json" -nt "$web/package-lock.json" ] && return
  (cd "$web" && npm ci --no-audit --no-fund --ignore-scripts --fetch-retries=1 >/dev/null 2>&1) ||
    echo "install-deps.sh: 'npm ci' in web/ failed; the viewer in a browser is left out" >&2
}

if [ ${#missing[@]} -eq 0 ]; then
  install_viewer_packages
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "install-deps.sh: run as root, or install: ${missing[*]}" >&2; exit 1; }
  as_root=(sudo)
fi
echo "installing: ${missing[*]}"
"${as_root[@]}" apt-get update -qq
DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
install_viewer_packages
