#!/usr/bin/python3
"""Plots what accuracy costs in time: errors of double bubbles at rest against CPU seconds, and the cost by stage.

usage: plot_accuracy.py DIR     reads DIR/accuracy.csv and, when there is one, DIR/evolver.csv; writes
                                DIR/accuracy_plot.png (errors against time) and DIR/cost_plot.png (stages)
"""
import csv
import sys
from pathlib import Path

from drawing import plt, save
from matplotlib.lines import Line2D

COLOURS = {"naive": "tab:red", "constant-edge": "tab:orange", "averaged": "tab:blue"}
STAGES = ["effects", "velocity", "move", "remesh", "geometry", "rest"]
MARKERS = ["o", "s", "^", "D", "v", "P", "X", "*"]


def read_rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def schemes(rows):
    """The pairs of integrator and dt, in the file's order."""
    return list(dict.fromkeys((row["integrator"], row["dt"]) for row in rows))


def series(rows, area, scheme, column):
    """CPU seconds, magnitudes and whether it came to rest, for every run of one strategy and scheme."""
    chosen = [row for row in rows if row["area"] == area and (row["integrator"], row["dt"]) == scheme and row[column]]
    return ([float(row["cpu_seconds"]) for row in chosen], [abs(float(row[column])) for row in chosen],
            [row["ended"] == "at rest" for row in chosen])


def plot_precision(axes, rows, column, evolver, evolver_column):
    """The first scheme is a line for each strategy; the others are markers of its colour."""
    for area in dict.fromkeys(row["area"] for row in rows):
        colour = COLOURS.get(area)
        for marker, scheme in zip(MARKERS, schemes(rows)):
            seconds, errors, at_rest = series(rows, area, scheme, column)
            is_first = scheme == schemes(rows)[0]
            axes.plot(seconds, errors, color=colour, linewidth=1.8 if is_first else 0, alpha=1 if is_first else 0.6)
            for x, y, filled in zip(seconds, errors, at_rest):
                axes.plot(x, y, marker=marker, color=colour, markerfacecolor=colour if filled else "white",
                          markersize=6 if is_first else 5, alpha=1 if is_first else 0.6)
    if evolver and evolver_column:
        axes.plot([float(row["cpu_seconds"]) for row in evolver], [abs(float(row[evolver_column])) for row in evolver],
                  color="black", marker=".", linestyle="--")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("CPU seconds to rest")
    axes.grid(alpha=0.3, which="both")


def legend_entries(rows, evolver):
    entries = [Line2D([], [], color=COLOURS.get(area), linewidth=1.8, label=area)
               for area in dict.fromkeys(row["area"] for row in rows)]
    for marker, (integrator, dt) in zip(MARKERS, schemes(rows)):
        entries.append(Line2D([], [], color="grey", marker=marker, linestyle="", label=f"{integrator}, dt = {dt} T"))
    if any(row["ended"] != "at rest" for row in rows):
        entries.append(Line2D([], [], color="grey", marker="o", markerfacecolor="white", linestyle="",
                              label="not at rest in time"))
    if evolver:
        entries.append(Line2D([], [], color="black", marker=".", linestyle="--", label="Surface Evolver (equilibrium only)"))
    return entries


def plot_errors(folder, rows, evolver):
    panels = [("area_error", "relative error of the area", "area_error"),
              ("pressure_error", "relative error of the pressure", "pressure_error"),
              ("radius_error", "relative error of the outer radius", None),
              ("angle_rms_deg", "RMS deviation from 120°, facets (degrees)", "angle_rms_deg"),
              ("angle_rms_film_deg", "RMS deviation from 120°, films (degrees)", None)]
    panels = [panel for panel in panels if any(row[panel[0]] for row in rows)]
    figure, axes = plt.subplots(2, 3, figsize=(14, 8.4), constrained_layout=True)
    cells = list(axes.flat)
    for cell, (column, label, evolver_column) in zip(cells, panels):
        plot_precision(cell, rows, column, evolver, evolver_column)
        cell.set_ylabel(label)
    for cell in cells[len(panels):]:
        cell.axis("off")
    sizes = sorted({int(row["n"]) for row in rows})
    cells[-1].legend(handles=legend_entries(rows, evolver), loc="center", fontsize=10,
                     title="N = " + ", ".join(map(str, sizes)) + ", coarse to fine along a line")
    save(figure, folder / "accuracy_plot.png", dpi=130)
    plt.close(figure)


def share(row, stage):
    """The stage's part of a run's wall time."""
    return float(row[f"seconds_{stage}"]) / sum(float(row[f"seconds_{name}"]) for name in STAGES)


def plot_cost(folder, rows):
    """CPU milliseconds of a step, shared out to the stages by their wall time: one bar a size and integrator, of the last
    strategy in the file."""
    area = rows[-1]["area"]
    integrators = list(dict.fromkeys(row["integrator"] for row in rows))
    figure, axes = plt.subplots(1, len(integrators), figsize=(5.5 * len(integrators), 4.4), sharey=True, squeeze=False,
                                constrained_layout=True)
    for cell, integrator in zip(axes[0], integrators):
        dt = next(row["dt"] for row in rows if row["integrator"] == integrator)
        runs = [row for row in rows if (row["area"], row["integrator"], row["dt"]) == (area, integrator, dt)]
        labels = [f"N = {row['n']}\n{row['triangles']}" for row in runs]
        bottom = [0.0] * len(runs)
        for stage in STAGES:
            heights = [1e3 * float(row["cpu_seconds"]) / max(1, int(row["steps"])) * share(row, stage) for row in runs]
            cell.bar(labels, heights, bottom=bottom, label=stage)
            bottom = [b + h for b, h in zip(bottom, heights)]
        cell.set_title(f"{area}, {integrator}, dt = {dt} T")
        cell.set_xlabel("size and triangles at rest")
        cell.grid(axis="y", alpha=0.3)
    axes[0][0].set_ylabel("CPU milliseconds a step")
    axes[0][0].legend()
    save(figure, folder / "cost_plot.png", dpi=130)
    plt.close(figure)


def main(folder):
    rows = read_rows(folder / "accuracy.csv")
    evolver = read_rows(folder / "evolver.csv") if (folder / "evolver.csv").exists() else []
    if not rows:
        sys.exit("accuracy.csv has no rows")
    plot_errors(folder, rows, evolver)
    plot_cost(folder, rows)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))
