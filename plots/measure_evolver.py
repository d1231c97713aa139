#!/usr/bin/python3
"""Measures Surface Evolver (Brakke 1992, package evolver-nox) on the double bubble: error against CPU time.

usage: measure_evolver.py DIR [LEVELS]     writes DIR/evolver.csv, one line a level of refinement (default 5 levels),
                                           and DIR/evolver.fe, the start surface; does nothing where no 'evolver' is

Two equal bubbles with linear elements, from 66 facets. At each level: gradient steps with vertex averaging, then Hessian
steps until the area stays; 'cpu_seconds' is the program's own clock since its start, without the printing.
"""
import csv
import math
import shutil
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

VOLUME = 4.02694  # of one bubble; the report's start shape at N = 16
SEGMENTS = 6
EVOLVE = "{ g 5; V; g 5; V; g 10; hessian; hessian; hessian }"


def start_surface():
    """Points, and facets as (a, b, c, front body, back body): body 1 at x < 0, body 2 at x > 0, 0 the air."""
    radius = (8 * VOLUME / (9 * math.pi)) ** (1 / 3)
    points, facets = [], []

    def ring(x, distance, phase):
        first = len(points)
        for k in range(SEGMENTS):
            angle = 2 * math.pi * (k + phase) / SEGMENTS
            points.append((x, distance * math.cos(angle), distance * math.sin(angle)))
        return [first + k for k in range(SEGMENTS)]

    def strip(outer, inner, leaning, front, back):
        for k in range(SEGMENTS):
            after = (k + 1) % SEGMENTS
            near = inner[k] if leaning else inner[after]
            facets.append((outer[k], outer[after], near, front, back))
            facets.append((outer[after] if leaning else outer[k], inner[after], inner[k], front, back))

    def fan(loop, pole, front, back):
        for k in range(SEGMENTS):
            facets.append((loop[k], loop[(k + 1) % SEGMENTS], pole, front, back))

    rim = ring(0, radius * math.sqrt(3) / 2, 0)
    for side, body in ((-1, 1), (1, 2)):
        # Normals point along +x at the pole: outwards on the right only.
        front, back = (0, body) if side > 0 else (body, 0)
        outer = rim
        for row, degrees in enumerate((80, 40), 1):  # the rim lies at 120 degrees from the pole
            angle = math.radians(degrees)
            inner = ring(side * radius * (0.5 + math.cos(angle)), radius * math.sin(angle), row / 2)
            strip(outer, inner, row % 2, front, back)
            outer = inner
        points.append((side * 1.5 * radius, 0, 0))
        fan(outer, len(points) - 1, front, back)
    points.append((0, 0, 0))
    fan(rim, len(points) - 1, 2, 1)
    return points, facets


def write_datafile(path, points, facets, volumes):
    """A start surface for evolver; volumes by body."""
    edges = {}

    def edge(a, b):
        key = (min(a, b), max(a, b))
        number = edges.setdefault(key, len(edges) + 1)
        return number if (a, b) == key else -number

    loops = [(edge(a, b), edge(b, c), edge(c, a)) for a, b, c, _, _ in facets]
    bodies = defaultdict(list)
    for i, (_, _, _, front, back) in enumerate(facets, 1):
        bodies[back].append(i)  # its normal points out of the body behind
        bodies[front].append(-i)
    lines = ["vertices"]
    lines += [f"{i} {x:.17g} {y:.17g} {z:.17g}" for i, (x, y, z) in enumerate(points, 1)]
    lines += ["edges"] + [f"{i} {a + 1} {b + 1}" for (a, b), i in edges.items()]
    lines += ["faces"] + [f"{i} {a} {b} {c}" for i, (a, b, c) in enumerate(loops, 1)]
    lines += ["bodies"] + [f"{b} {' '.join(map(str, bodies[b]))} volume {v:.17g}" for b, v in volumes.items()]
    path.write_text("\n".join(lines) + "\n")


def commands(levels):
    report = ('printf "LEVEL %d %.15g %.15g %.6f\\n", facet_count, total_area, body[1].pressure, stopped;'
              ' foreach vertex vv do printf "X %d %.15g %.15g %.15g\\n", vv.id, vv.x, vv.y, vv.z;'
              ' foreach facet ff do printf "F %d %d %d\\n", ff.vertex[1].id, ff.vertex[2].id, ff.vertex[3].id')
    lines = ["quiet on", "spent := 0; begun := 0; stopped := 0"]
    for level in range(levels):
        refine = "r;" if level > 0 else ""
        lines.append(f"begun := clock; {refine} {EVOLVE}; spent := spent + clock - begun; stopped := spent; {report}")
    return "\n".join(lines + ["q", "q", ""])


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(dot(a, a))
    return tuple(x / length for x in a)


def angle_rms(points, facets):
    """RMS of (angle - 120 degrees) between neighbouring half-planes at all edges of three facets."""
    around = defaultdict(list)
    for f in facets:
        for i in range(3):
            around[frozenset((f[i], f[(i + 1) % 3]))].append(f[(i + 2) % 3])
    squares, count = 0.0, 0
    for ends, opposite in around.items():
        if len(opposite) != 3:
            continue
        a, b = (points[i] for i in sorted(ends))
        along = unit(subtract(b, a))
        away = [subtract(points[i], a) for i in opposite]
        away = [unit(subtract(d, tuple(dot(d, along) * x for x in along))) for d in away]
        side = cross(along, away[0])
        turns = sorted(math.degrees(math.atan2(dot(d, side), dot(d, away[0]))) % 360 for d in away)
        gaps = [turns[1] - turns[0], turns[2] - turns[1], 360 + turns[0] - turns[2]]
        squares += sum((gap - 120) ** 2 for gap in gaps)
        count += 3
    return math.sqrt(squares / count)


def parse(text):
    """One dict a level of what evolver printed."""
    levels = []
    for line in text.splitlines():
        words = line.split()
        if line.startswith("LEVEL "):
            levels.append({"facets": int(words[1]), "area": float(words[2]), "pressure": float(words[3]),
                           "cpu_seconds": float(words[4]), "points": {}, "triangles": []})
        elif line.startswith("X ") and levels:
            levels[-1]["points"][int(words[1])] = tuple(map(float, words[2:5]))
        elif line.startswith("F ") and levels:
            levels[-1]["triangles"].append(tuple(map(int, words[1:4])))
    return levels


def main(folder, levels):
    if shutil.which("evolver") is None:
        print("Surface Evolver (package evolver-nox) is not installed: its curve is left out")
        return
    datafile = folder / "evolver.fe"
    write_datafile(datafile, *start_surface(), {1: VOLUME, 2: VOLUME})
    result = subprocess.run(["evolver", str(datafile)], input=commands(levels), capture_output=True, text=True,
                            check=False, timeout=600)
    found = parse(result.stdout)
    if len(found) != levels:
        sys.exit(f"evolver gave {len(found)} levels instead of {levels}:\n{result.stdout[-2000:]}{result.stderr[-2000:]}")
    radius = (8 * VOLUME / (9 * math.pi)) ** (1 / 3)
    exact = 27 / 4 * math.pi * radius**2
    with open(folder / "evolver.csv", "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["level", "facets", "area_error", "pressure_error", "angle_rms_deg", "cpu_seconds"])
        for level, row in enumerate(found):
            table.writerow([level, row["facets"], row["area"] / exact - 1, row["pressure"] * radius / 2 - 1,
                            angle_rms(row["points"], row["triangles"]), row["cpu_seconds"]])


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) == 3 else 5)
