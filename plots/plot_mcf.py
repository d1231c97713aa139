#!/usr/bin/python3
"""Growth of the cells of a coarsening foam by their number of faces, from volumes.csv of `multitracker run mcf`.

usage: plot_mcf.py RUN_DIR [OUT.png] [--every STEPS]

Cells inside and cells at a wall are drawn apart. Under mean curvature flow of films of tension 1 the growth of a cell of volume V
goes as V^(1/3); plotted is V^(-1/3) dV/dt, the three-dimensional counterpart of von Neumann's and Mullins' law
(MacPherson and Srolovitz 2007): cells with few faces shrink, cells with many grow.
"""

import argparse
import csv
import os
from collections import defaultdict

from drawing import plt


def read_cells(path):
    cells = defaultdict(dict)
    times = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            step = int(row["step"])
            times[step] = float(row["time"])
            cells[int(row["region"])][step] = (float(row["volume"]), int(row["faces"]), row["touches_air"] == "1")
    return cells, times


def growth_rates(cells, times, every):
    rates = {False: defaultdict(list), True: defaultdict(list)}
    for history in cells.values():
        for step, (volume, faces, at_wall) in history.items():
            later = history.get(step + every)
            if step % every != 0 or later is None or later[1] != faces or volume <= 0:
                continue
            dt = times[step + every] - times[step]
            rates[at_wall][faces].append((later[0] - volume) / dt / volume ** (1 / 3))
    return rates


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("run_dir")
    parser.add_argument("out", nargs="?")
    parser.add_argument("--every", type=int, default=5, help="steps over which a growth rate is taken")
    arguments = parser.parse_args()
    cells, times = read_cells(os.path.join(arguments.run_dir, "volumes.csv"))
    out = arguments.out or os.path.join(arguments.run_dir, "mcf.png")

    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2))
    styles = {False: ("o", "C0", "inside"), True: ("s", "C1", "at a wall")}
    for at_wall, by_faces in growth_rates(cells, times, arguments.every).items():
        marker, colour, label = styles[at_wall]
        faces = sorted(by_faces)
        if not faces:
            continue
        means = [sum(by_faces[f]) / len(by_faces[f]) for f in faces]
        for f in faces:
            left.plot([f] * len(by_faces[f]), by_faces[f], ".", color=colour, alpha=0.15, markersize=3)
        left.plot(faces, means, marker + "-", color=colour, label=f"mean, cells {label}")
    left.axhline(0, color="0.5", linewidth=0.8)
    left.set_xlabel("faces of the cell (other cells it has a film with)")
    left.set_ylabel("$V^{-1/3}\\,dV/dt$ (length / time)")
    left.set_title("growth by number of faces")
    left.legend()

    steps = sorted(times)
    counts = [sum(1 for history in cells.values() if history.get(step, (0,))[0] > 0) for step in steps]
    right.plot([times[step] for step in steps], counts, color="C2")
    right.set_xlabel("time")
    right.set_ylabel("cells")
    right.set_ylim(bottom=0)
    right.set_title("cells that are left")
    figure.tight_layout()
    figure.savefig(out, dpi=130)
    print(out)


if __name__ == "__main__":
    main()
