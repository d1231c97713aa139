#!/usr/bin/python3
"""Plots a comparison of area strategies: angle, centroid and energy against time, one line a strategy.

usage: plot_compare.py DIR     DIR as 'foamsim compare' leaves it; reads compare.csv and STRATEGY/metrics.csv, writes
                               DIR/compare_plot.png
"""
import csv
import math
import sys
from pathlib import Path

from drawing import plt, save


def read_columns(path, names):
    """The named columns of a CSV file as lists of floats; empty cells become NaN."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return [[float(row[name]) if row[name] else math.nan for row in rows] for name in names]


def strategies(folder):
    with open(folder / "compare.csv", newline="") as file:
        return [row["area"] for row in csv.DictReader(file)]


def main(folder):
    figure, (angle_axes, drift_axes, energy_axes) = plt.subplots(1, 3, figsize=(13, 4), constrained_layout=True)
    has_angles = False
    for area in strategies(folder):
        names = ["time", "angle_outer_mean_deg", "centroid_x", "centroid_y", "centroid_z", "area", "energy"]
        time, angle, x, y, z, _, energy = read_columns(folder / area / "metrics.csv", names)
        drift = [math.dist(p, (x[0], y[0], z[0])) for p in zip(x, y, z)]
        has_angles = has_angles or not all(math.isnan(a) for a in angle)
        angle_axes.plot(time, angle, label=area)
        # The start is zero exactly, which a logarithmic axis cannot show.
        drift_axes.plot(time[1:], [max(d, 1e-16) for d in drift[1:]], label=area)
        energy_axes.plot(time, energy, label=area)
    if has_angles:
        angle_axes.axhline(120, color="grey", linestyle="--", linewidth=1, label="Plateau: 120°")
    angle_axes.set_ylabel("mean outer dihedral angle (degrees)")
    drift_axes.set_ylabel("drift of the films' centroid (L)")
    drift_axes.set_yscale("log")
    energy_axes.set_ylabel("energy, surface + kinetic (L⁵/T²)")
    for axes in (angle_axes, drift_axes, energy_axes):
        axes.set_xlabel("time (T)")
        axes.grid(alpha=0.3)
        axes.legend()
    save(figure, folder / "compare_plot.png", dpi=150)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))
