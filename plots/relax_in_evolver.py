#!/usr/bin/python3
"""Lets Surface Evolver (Brakke 1992, package evolver-nox) relax a frame of foamsim on the very same triangles.

usage: relax_in_evolver.py FRAME.ply OUT.ply     also writes OUT.fe, the data file

Newton steps (hessian) at fixed volumes until the area stays: what is left to be won on this mesh. Prints area and RMS
deviation of junction facets from 120 degrees before and after, and how far vertices went.
"""
import math
import shutil
import struct
import subprocess
import sys
from pathlib import Path

from measure_evolver import angle_rms, cross, dot, subtract, write_datafile

RELAX = "g 5; hessian; hessian; hessian; hessian"


def read_ply(path):
    """Points, and facets as (a, b, c, front body, back body), of a binary frame of foamsim; and its header."""
    data = Path(path).read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode()
    counts = [int(line.split()[2]) for line in header.splitlines() if line.startswith("element")]
    if "property double x" not in header or "property int region_b" not in header or len(counts) != 2:
        sys.exit(f"{path}: not a frame that foamsim wrote")
    points = list(struct.iter_unpack("<3d", data[end:end + 24 * counts[0]]))
    facets = []
    for sides, a, b, c, p, q in struct.iter_unpack("<B5i", data[end + 24 * counts[0]:]):
        assert sides == 3
        facets.append((a, b, c, q, p))  # the normal points out of region_a
    return points, facets, header


def volumes_of(points, facets):
    volumes = {}
    for a, b, c, front, back in facets:
        part = dot(points[a], cross(points[b], points[c])) / 6
        volumes[back] = volumes.get(back, 0) + part
        volumes[front] = volumes.get(front, 0) - part
    return {body: volume for body, volume in sorted(volumes.items()) if body != 0}


def area_of(points, facets):
    total = 0
    for a, b, c, _, _ in facets:
        normal = cross(subtract(points[b], points[a]), subtract(points[c], points[a]))
        total += math.sqrt(dot(normal, normal)) / 2
    return total


def relaxed(datafile, count):
    report = 'foreach vertex vv do printf "X %d %.17g %.17g %.17g\\n", vv.id, vv.x, vv.y, vv.z'
    result = subprocess.run(["evolver", str(datafile)], input=f"quiet on\n{RELAX}\n{report}\nq\nq\n",
                            capture_output=True, text=True, check=False, timeout=600)
    rows = [line.split() for line in result.stdout.splitlines() if line.startswith("X ")]
    points = {int(row[1]) - 1: tuple(map(float, row[2:5])) for row in rows}
    if len(points) != count:
        sys.exit(f"evolver gave {len(points)} vertices of {count}:\n{result.stdout[-2000:]}{result.stderr[-2000:]}")
    return [points[i] for i in range(count)]


def main(source, target):
    if shutil.which("evolver") is None:
        sys.exit("Surface Evolver (package evolver-nox) is not installed")
    points, facets, header = read_ply(source)
    datafile = Path(target).with_suffix(".fe")
    write_datafile(datafile, points, facets, volumes_of(points, facets))
    after = relaxed(datafile, len(points))
    body = b"".join(struct.pack("<3d", *x) for x in after)
    body += b"".join(struct.pack("<B5i", 3, a, b, c, back, front) for a, b, c, front, back in facets)
    Path(target).write_bytes(header.encode() + body)
    triangles = [facet[:3] for facet in facets]
    for name, now in (("before", points), ("after", after)):
        print(f"{name}: area {area_of(now, facets):.10g}, facets' RMS deviation {angle_rms(now, triangles):.4f} degrees")
    farthest = max(math.dist(x, y) for x, y in zip(points, after))
    print(f"largest way of a vertex {farthest:.3g}; volumes {volumes_of(after, facets)}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
