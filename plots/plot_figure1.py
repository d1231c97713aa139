#!/usr/bin/env python3
"""Plots the three strategies of figure 1 against time: centroid, outer angle, energy.

usage: plot_figure1.py DIR    reads DIR/compare.csv and DIR/STRATEGY/metrics.csv, writes DIR/figure1_plot.png
"""
import math
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from csv_columns import column, read_rows


def main(folder):
    figure, (drift_axes, angle_axes, energy_axes) = plt.subplots(1, 3, figsize=(13, 4), constrained_layout=True)
    for row in read_rows(folder / "compare.csv"):
        rows = read_rows(folder / row["area"] / "metrics.csv")
        time = column(rows, "time")
        path = list(zip(*(column(rows, f"centroid_{axis}") for axis in "xyz")))
        drift_axes.plot(time, [math.dist(place, path[0]) for place in path], label=row["area"])
        angle_axes.plot(time, column(rows, "angle_outer_mean_deg"), linewidth=1, label=row["area"])
        energy_axes.plot(time, column(rows, "energy"), linewidth=1, label=row["area"])
    angle_axes.axhline(120, color="grey", linestyle="--", linewidth=1, label="Plateau: 120°")
    drift_axes.set_ylabel("drift of the films' centroid (L)")
    angle_axes.set_ylabel("mean outer angle between facets (degrees)")
    energy_axes.set_ylabel("energy, surface + kinetic (L⁵/T²)")
    for axes in (drift_axes, angle_axes, energy_axes):
        axes.set_xlabel("time (T)")
        axes.grid(alpha=0.3)
        axes.legend()
    figure.savefig(folder / "figure1_plot.png", dpi=150)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))
