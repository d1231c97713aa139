#!/usr/bin/python3
"""Figure 1: labels the frames of the three strategies, and plots centroid, outer angle and energy against time.

usage: plot_figure1.py DIR    reads DIR/figure1_frames.png, DIR/compare.csv, DIR/STRATEGY/metrics.csv and the names of
                              DIR/STRATEGY/frames; writes DIR/figure1.png and DIR/figure1_plot.png
"""
import math
import sys
from pathlib import Path

from drawing import plt, save

from csv_columns import column, read_rows


def label_frames(folder, strategies):
    """The sheet of frames, a row a strategy and a column a time, with the names of both and the outer angle, which swings,
    as its mean over the second half of the time."""
    sheet = plt.imread(folder / "figure1_frames.png")
    height, width = sheet.shape[:2]
    columns = len(list((folder / strategies[0]["area"] / "frames").iterdir()))
    last_time = float(strategies[0]["time"])
    inches = 12
    figure = plt.figure(figsize=(inches, inches * height / width + 0.3), dpi=width / inches)
    sheet_height = (inches * height / width) / (inches * height / width + 0.3)
    axes = figure.add_axes([0, 0, 1, sheet_height])
    axes.imshow(sheet, aspect="auto", extent=(0, columns, len(strategies), 0))
    axes.set_axis_off()
    for i in range(columns):
        figure.text((i + 0.5) / columns, (1 + sheet_height) / 2, f"time {last_time * i / (columns - 1):g}",
                    ha="center", va="center", fontsize=12)
    for i, row in enumerate(strategies):
        axes.text(0.05, i + 0.06, row["area"], color="white", va="top", fontsize=13)
        rows = read_rows(folder / row["area"] / "metrics.csv")
        swing = [angle for time, angle in zip(column(rows, "time"), column(rows, "angle_outer_mean_deg"))
                 if time > last_time / 2]
        axes.text(columns - 0.05, i + 0.06, f"outer angle {sum(swing) / len(swing):.0f}°", color="white",
                  ha="right", va="top", fontsize=11)
    figure.savefig(folder / "figure1.png")


def plot_over_time(folder, strategies):
    figure, (drift_axes, angle_axes, energy_axes) = plt.subplots(1, 3, figsize=(13, 4), constrained_layout=True)
    for row in strategies:
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
    save(figure, folder / "figure1_plot.png", dpi=150)


def main(folder):
    strategies = read_rows(folder / "compare.csv")
    label_frames(folder, strategies)
    plot_over_time(folder, strategies)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))
