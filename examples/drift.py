#!/usr/bin/env python3
"""How far a run's films have moved, and how much energy and volume they have lost: examples/drift.py RUN."""
import csv
import math
import pathlib
import sys


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with open(pathlib.Path(sys.argv[1]) / "metrics.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    start, end = rows[0], rows[-1]
    centre = [f"centroid_{axis}" for axis in "xyz"]
    moved = math.dist([float(start[c]) for c in centre], [float(end[c]) for c in centre])
    highest = max(float(row["energy"]) for row in rows[1:])
    print(f"time {float(end['time']):g}: moved by {moved:.4f}, "
          f"energy {float(end['energy']):.4f} (highest {highest:.4f}), "
          f"volume drift {100 * float(end['volume_drift_max']):.3f}%")


if __name__ == "__main__":
    main()
