#!/usr/bin/python3
"""Plots bubbles that oscillate in one mode: amplitude against time beside linear theory, and error against delta.

usage: plot_modes.py DIR     reads DIR/modes.csv and DIR/modes_summary.csv, writes DIR/modes_plot.png
"""
import csv
import sys
from pathlib import Path

from drawing import plt, save


def read_rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def values_of(rows, column):
    """The distinct whole numbers in a column, ascending."""
    return sorted({int(row[column]) for row in rows})


def legend_below(axes):
    axes.legend(fontsize=8, loc="upper center", bbox_to_anchor=(0.5, -0.15), ncol=2)


def plot_amplitudes(axes, rows, mode):
    rows = [row for row in rows if int(row["mode"]) == mode]
    resolutions = values_of(rows, "triangles")
    for triangles in resolutions:
        run = [row for row in rows if int(row["triangles"]) == triangles]
        time = [float(row["time"]) for row in run]
        axes.plot(time, [float(row["measured"]) for row in run], linewidth=1, label=f"{triangles} triangles")
        if triangles == resolutions[0]:
            # The coarsest oscillates slowest, so that its theory goes on for longest.
            theory = [float(row["theory"]) for row in run]
            axes.plot(time, theory, color="black", linestyle="--", linewidth=1, label="linear theory")
    axes.set_title(f"mode {mode}")
    axes.set_xlabel("time (T)")
    axes.set_ylabel("amplitude / radius")
    axes.grid(alpha=0.3)
    legend_below(axes)


def plot_errors(axes, rows):
    for mode in values_of(rows, "mode"):
        runs = [row for row in rows if int(row["mode"]) == mode and float(row["delta"]) > 0]
        delta = [float(row["delta"]) for row in runs]
        error = [abs(float(row["frequency_error"])) for row in runs]
        axes.loglog(delta, error, marker="o", label=f"mode {mode}")
        for row in rows:
            if int(row["mode"]) == mode and float(row["delta"]) == 0:
                remainder = abs(float(row["frequency_error"]))
                axes.axhline(remainder, color=axes.lines[-1].get_color(), linestyle=":", linewidth=1,
                             label=f"mode {mode}, extrapolated to δ = 0: {100 * remainder:.2g} %")
    delta = sorted(float(row["delta"]) for row in rows if float(row["delta"]) > 0)
    axes.loglog(delta, [0.5 * d for d in delta], color="grey", linestyle="--", linewidth=1, label="first order")
    axes.set_xlabel("regularisation δ (L)")
    axes.set_ylabel("|ω / ω of theory − 1|")
    axes.grid(alpha=0.3, which="both")
    legend_below(axes)


def main(folder):
    series = read_rows(folder / "modes.csv")
    summary = read_rows(folder / "modes_summary.csv")
    modes = values_of(series, "mode")
    figure, axes = plt.subplots(1, len(modes) + 1, figsize=(5 * (len(modes) + 1), 4.5), constrained_layout=True)
    for mode, mode_axes in zip(modes, axes):
        plot_amplitudes(mode_axes, series, mode)
    plot_errors(axes[-1], summary)
    save(figure, folder / "modes_plot.png", dpi=150)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))
