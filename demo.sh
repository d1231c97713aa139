#!/usr/bin/env bash
# The main job: a double bubble under the three area strategies. Table on the screen; pictures, plots and ParaView files in
# out/demo. A second run shows what is there; `./demo.sh --again` computes it anew.
set -euo pipefail
cd "$(dirname "$0")"

out=out/demo
./install-deps.sh --to-run
cmake --preset release >/dev/null
cmake --build --preset release --target foamsim_program foamsim_manual multitracker_program multitracker_manual -j "$(nproc)"

if [ "${1:-}" = "--again" ] || [ ! -f "$out/compare.png" ]; then
  build/bin/foamsim compare assets/scenes/demo.toml --out "$out" --force
else
  build/bin/foamsim compare --show "$out"
fi
# Where the viewer is built: docs/viewer.md.
if build/bin/foamsim export-web "$out/averaged" "$out/averaged.html" --force --quiet 2>/dev/null; then
  echo "in a browser: $out/averaged.html"
fi
echo "pictures: $out/compare.png   plots: $out/compare_plot.png   ParaView: $out/*/surface.pvd"
