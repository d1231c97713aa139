#!/usr/bin/python3
"""Plots the rest angles of double bubbles against resolution, beside the published ones and those of exact bubbles.

usage: plot_table1.py DIR     reads DIR/table1.csv, writes DIR/table1_plot.png
"""
import sys
from pathlib import Path

from drawing import plt, save

from csv_columns import column, read_rows


def plot_measure(axes, rows, name):
    for area in dict.fromkeys(row["area"] for row in rows):
        # A run that has not come to rest has no rest angle.
        run = sorted((row for row in rows if row["area"] == area), key=lambda row: int(row["n"]))
        line, = axes.plot(column(run, "n"), column(run, name), marker="o", label=area)
        moving = [row for row in run if row["ended"] != "at rest"]
        axes.plot(column(moving, "n"), column(moving, name), linestyle="none", marker="o", markersize=11,
                  markerfacecolor="none", color=line.get_color(), label=f"{area}: not at rest" if moving else None)


def finish(axes, title, subdivisions):
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xticks(subdivisions, [str(n) for n in subdivisions])
    axes.set_yticks([1, 2, 5, 10, 20, 30], ["1°", "2°", "5°", "10°", "20°", "30°"])
    axes.minorticks_off()
    axes.set_xlabel("subdivisions N of each bubble")
    axes.set_ylabel("RMS deviation from 120°")
    axes.set_title(title)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)


def main(folder):
    rows = read_rows(folder / "table1.csv")
    figure, (facet_axes, film_axes) = plt.subplots(1, 2, figsize=(11, 4.5), sharey=True, constrained_layout=True)
    plot_measure(facet_axes, rows, "angle_rms_deg")
    plot_measure(film_axes, rows, "angle_rms_film_deg")
    published = sorted((row for row in rows if row["published_deg"]), key=lambda row: int(row["n"]))
    facet_axes.plot(column(published, "n"), column(published, "published_deg"), color="black", marker="s",
                    linestyle="--", label="Fei et al. 2019, averaged")
    exact = sorted((row for row in rows if row["area"] == "averaged"), key=lambda row: int(row["n"]))
    facet_axes.plot(column(exact, "n"), column(exact, "exact_facets_deg"), color="grey", linestyle=":", marker=".",
                    label="exact double bubble, same edge length")
    subdivisions = sorted({int(row["n"]) for row in rows})
    finish(facet_axes, "between facets, as the report measures", subdivisions)
    finish(film_axes, "between the curved films", subdivisions)
    facet_axes.set_ylim(0.8, 45)
    save(figure, folder / "table1_plot.png", dpi=150)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))
