#!/usr/bin/env bash
# Sets up what is missing, builds, and runs every test but the long ones (ctest -L long). --asan: also the quick tests in
# a sanitizer build.
set -euo pipefail
cd "$(dirname "$0")"

./install-deps.sh
jobs=$(nproc)
cmake --preset release -DFOAMSIM_WERROR=ON >/dev/null
cmake --build --preset release -j "$jobs"
ctest --preset release -j "$jobs"

if [ "${1:-}" = "--asan" ]; then
  cmake --preset asan -DFOAMSIM_WERROR=ON >/dev/null
  cmake --build --preset asan -j "$jobs"
  ctest --preset asan -j "$jobs"
fi
