#!/usr/bin/env bash
# Sets up what is missing, builds, and runs every test but the long ones (ctest -L long). --asan: also the quick tests in
# a sanitizer build, by clang.
set -euo pipefail
cd "$(dirname "$0")"

./install-deps.sh
jobs=$(nproc)
# Warnings are errors in continuous integration; elsewhere another compiler may warn of other things.
cmake --preset release ${CI:+-DFOAMSIM_WERROR=ON} >/dev/null
cmake --build --preset release -j "$jobs"
ctest --preset release -j "$jobs"

if [ "${1:-}" = "--asan" ]; then
  cmake --preset asan ${CI:+-DFOAMSIM_WERROR=ON} >/dev/null
  cmake --build --preset asan -j "$jobs"
  ctest --preset asan -j "$jobs"
fi
