#!/usr/bin/python3
"""Draws the stretched junction: three films at 120° before and after, and each region's curvature by strategy.

usage: plot_figure3.py DIR    reads DIR/figure3.csv, writes DIR/figure3.png
"""
import math
import sys
from pathlib import Path

from drawing import plt, save

from csv_columns import read_rows

STRETCH = 2.0
ROWS = 2
COLOURS = ["tab:blue", "tab:orange", "tab:green"]


def draw_junction(axes, stretch, title):
    """The films seen along the border; film i lies between regions i and i + 1, dots are rows of vertices."""
    for film in range(3):
        angle = math.radians(90 + 120 * film)
        reach = stretch if film == 1 else 1
        end = ROWS * reach
        axes.plot([0, end * math.cos(angle)], [0, end * math.sin(angle)], color="black", linewidth=2,
                  solid_capstyle="round")
        for row in range(ROWS + 1):
            axes.plot(row * reach * math.cos(angle), row * reach * math.sin(angle), "o", color="black", markersize=6)
        # Region i + 1 follows film i in the turn.
        middle = angle + math.radians(60)
        region = (film + 1) % 3
        axes.text(1.35 * math.cos(middle), 1.35 * math.sin(middle), str(region), color=COLOURS[region], fontsize=16,
                  ha="center", va="center", fontweight="bold")
    axes.set_xlim(-4, 2.4)
    axes.set_ylim(-2.6, 2.4)
    axes.set_aspect("equal")
    axes.axis("off")
    axes.set_title(title)


def main(folder):
    rows = read_rows(folder / "figure3.csv")
    areas = list(dict.fromkeys(row["area"] for row in rows))
    values = {(row["area"], float(row["stretch"]), int(row["region"])): float(row["curvature"]) for row in rows}
    figure, (before, after, bars) = plt.subplots(1, 3, figsize=(13, 4), constrained_layout=True,
                                                 width_ratios=[1, 1, 1.5])
    draw_junction(before, 1, "three films at 120°")
    draw_junction(after, STRETCH, f"film between 1 and 2 stretched {STRETCH:g} : 1,\nevery angle as before")
    for place, area in enumerate(areas):
        for region in range(3):
            left = place + 0.27 * (region - 1)
            bars.bar(left - 0.06, values[area, 1.0, region], width=0.11, color=COLOURS[region], alpha=0.35,
                     label=f"region {region} before" if place == 0 else None)
            bars.bar(left + 0.06, values[area, STRETCH, region], width=0.11, color=COLOURS[region],
                     label=f"region {region} after" if place == 0 else None)
    bars.set_xticks(range(len(areas)), areas)
    bars.set_ylabel("curvature H at the border (1/L)")
    bars.set_ylim(0, 1.5)
    bars.grid(alpha=0.3, axis="y")
    bars.legend(fontsize=8, ncol=3, loc="upper center")
    save(figure, folder / "figure3.png", dpi=150)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))
