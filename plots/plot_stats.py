#!/usr/bin/python3
"""Plots the statistics of a foam: bubbles, faces, volumes and pressures over time and as distributions, rates of changes.

usage: plot_stats.py DIR     DIR as 'foamsim stats' leaves it; reads foam.csv, bubbles.csv and distributions.csv, writes
                             DIR/stats_plot.png
"""
import sys
from pathlib import Path

from csv_columns import column, number, read_rows
from drawing import plt, save


def of_step(rows, step):
    return [row for row in rows if row["step"] == step]


def plot_over_time(axes, rows):
    time = column(rows, "time")
    marker = "o" if len(rows) < 30 else None
    axes.plot(time, column(rows, "bubbles"), marker=marker, markersize=3, color="black", label="bubbles")
    axes.set_xlabel("time (T)")
    axes.set_ylabel("bubbles")
    axes.set_ylim(bottom=0)
    right = axes.twinx()
    for name, label in [("t1_rate", "T1"), ("burst_rate", "bursts"), ("vanished_rate", "vanished")]:
        rates = column(rows, name)
        if any(rate > 0 for rate in rates):  # NaN is not
            right.step(time, rates, where="pre", linewidth=1, label=label)
    right.set_ylabel("changes a unit of time (1/T)")
    right.set_ylim(bottom=0)
    lines = axes.get_lines() + right.get_lines()
    axes.legend(lines, [line.get_label() for line in lines], fontsize=8)


def plot_mean(axes, rows, name, label):
    time, mean = column(rows, "time"), column(rows, f"{name}_mean")
    deviation = column(rows, f"{name}_deviation")
    marker = "o" if len(rows) < 30 else None
    axes.plot(time, mean, marker=marker, markersize=3, label="mean")
    axes.fill_between(time, [m - d for m, d in zip(mean, deviation)], [m + d for m, d in zip(mean, deviation)], alpha=0.2,
                      label="± standard deviation")
    axes.set_xlabel("time (T)")
    axes.set_ylabel(label)
    axes.legend(fontsize=8)


def plot_distribution(axes, rows, steps, quantity, label, width):
    """The first and the last frame side by side, as shares of all."""
    for place, (step, time) in enumerate(steps):
        found = [row for row in of_step(rows, step) if row["quantity"] == quantity]
        total = sum(number(row["count"]) for row in found)
        bar = width / len(steps)
        axes.bar([number(row["value"]) + bar * (place - (len(steps) - 1) / 2) for row in found],
                 [number(row["count"]) / total for row in found], width=0.9 * bar, label=f"time {time:g}")
    axes.set_xlabel(label)
    axes.set_ylabel("share")
    if axes.get_legend_handles_labels()[0]:
        axes.legend(fontsize=8)


def plot_pressures(axes, rows, steps):
    for step, time in steps:
        found = of_step(rows, step)
        axes.plot(column(found, "volume"), column(found, "pressure"), "o", markersize=3, label=f"time {time:g}")
    axes.set_xlabel("volume of the bubble (L³)")
    axes.set_ylabel("pressure over tension (1/L)")
    axes.legend(fontsize=8)


def main(folder):
    foam, bubbles = read_rows(folder / "foam.csv"), read_rows(folder / "bubbles.csv")
    distributions = read_rows(folder / "distributions.csv")
    ends = [foam[0], foam[-1]] if len(foam) > 1 else [foam[0]]
    steps = [(row["step"], number(row["time"])) for row in ends]
    figure, axes = plt.subplots(2, 4, figsize=(18, 8), constrained_layout=True)
    plot_over_time(axes[0][0], foam)
    plot_mean(axes[0][1], foam, "faces", "faces of a bubble")
    plot_mean(axes[0][2], foam, "film_edges", "edges of a film")
    plot_mean(axes[0][3], foam, "pressure", "pressure over tension (1/L)")
    plot_distribution(axes[1][0], distributions, steps, "faces", "faces of a bubble", 1)
    plot_distribution(axes[1][1], distributions, steps, "film_edges", "edges of a film", 1)
    plot_distribution(axes[1][2], distributions, steps, "volume", "volume over the mean", 0.2)
    plot_pressures(axes[1][3], bubbles, steps)
    for one in axes.flat:
        one.grid(alpha=0.3)
    save(figure, folder / "stats_plot.png", dpi=120)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))
