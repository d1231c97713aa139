#!/usr/bin/env python3
"""What a run has lost or won of its energy, and how far its volumes have drifted: energy.py RUN_FOLDER"""
import csv
import pathlib
import sys


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: energy.py RUN_FOLDER")
    with open(pathlib.Path(sys.argv[1]) / "metrics.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    energy = [float(row["energy"]) for row in rows]
    drift = max(float(row["volume_drift_max"]) for row in rows)
    least = min(energy)
    print(f"steps {rows[-1]['step']}, time {rows[-1]['time']}")
    print(f"energy {energy[0]:.6g} -> {energy[-1]:.6g}, rise above its least {100 * (energy[-1] / least - 1):.3f}%")
    print(f"largest volume drift {100 * drift:.3f}%")


if __name__ == "__main__":
    main()
