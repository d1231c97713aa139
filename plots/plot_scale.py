#!/usr/bin/python3
"""What a step of a foam costs against its number of bubbles, by stage, from the run folders of a sweep over `bubbles`.

usage: plot_scale.py OUT.png RUN_DIR [RUN_DIR ...]

Prints a table, with the exponent of each stage: the slope of the straight line through the logarithms of time and triangles, by
least squares over runs of 30 bubbles and more.
"""

import argparse
import csv
import json
import math
import os

from drawing import plt

FEW = 30  # bubbles, below which constant costs show


def read_run(folder):
    with open(os.path.join(folder, "run.json")) as file:
        run = json.load(file)
    with open(os.path.join(folder, "metrics.csv"), newline="") as file:
        last = list(csv.DictReader(file))[-1]
    steps = run["last_step"] - run["first_step"]
    stages = {stage: seconds / steps for stage, seconds in run["stage_seconds"].items()}
    return {"bubbles": int(run["options"]["bubbles"]), "triangles": int(last["triangles"]), "stages": stages,
            "drift": float(last["volume_drift_max"]), "threads": run["threads"]}


def exponent(xs, ys):
    points = [(math.log(x), math.log(y)) for x, y in zip(xs, ys) if y > 0]
    if len(points) < 2:
        return float("nan")
    mx, my = (sum(p[i] for p in points) / len(points) for i in (0, 1))
    return sum((x - mx) * (y - my) for x, y in points) / sum((x - mx) ** 2 for x, _ in points)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out")
    parser.add_argument("runs", nargs="+")
    arguments = parser.parse_args()
    runs = sorted((read_run(folder) for folder in arguments.runs), key=lambda run: run["bubbles"])
    stages = sorted({stage for run in runs for stage in run["stages"]},
                    key=lambda stage: -runs[-1]["stages"].get(stage, 0))
    many = [run for run in runs if run["bubbles"] >= FEW]

    print("stage".ljust(18) + "".join(f"{run['bubbles']:>10}" for run in runs) + "  exponent")
    print("triangles".ljust(18) + "".join(f"{run['triangles']:>10}" for run in runs))
    figure, axes = plt.subplots(figsize=(8.8, 5.2))
    totals = {"a step": [sum(run["stages"].values()) for run in runs]}
    for stage in ["a step"] + stages:
        seconds = totals.get(stage) or [run["stages"].get(stage, 0) for run in runs]
        slope = exponent([run["triangles"] for run in many], seconds[-len(many):]) if many else float("nan")
        print(stage.ljust(18) + "".join(f"{1e3 * s:>10.3g}" for s in seconds) + f"{slope:>10.2f}   (ms)")
        if max(seconds) > 0.01 * max(totals["a step"]):
            axes.loglog([run["bubbles"] for run in runs], seconds, "o-", lw=2.5 if stage == "a step" else 1,
                        label=f"{stage} ({slope:.2f})")
    axes.set_xlabel("bubbles")
    axes.set_ylabel(f"seconds a step, {runs[0]['threads']} thread(s)")
    axes.grid(True, which="both", alpha=0.3)
    axes.legend(fontsize=8, title="stage (exponent in triangles)", loc="center left", bbox_to_anchor=(1.01, 0.5))
    figure.tight_layout()
    figure.savefig(arguments.out, dpi=110)


if __name__ == "__main__":
    main()
