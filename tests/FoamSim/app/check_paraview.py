"""Asserts what VTK reads from two runs: of a double bubble with all fields, and of a ball of radius 1 with three.

usage: check_paraview.py DOUBLE_BUBBLE_FOLDER BALL_FOLDER
"""

import csv
import math
import os
import sys
import xml.etree.ElementTree as xml

from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

UNITS = {
    "circulation": "L^2/T", "mean_curvature": "1/L", "pressure_jump": "L^2/T^2", "sheet_strength": "L/T",
    "velocity": "L/T",
}


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def series(folder):
    return [(float(frame.get("timestep")), os.path.join(folder, frame.get("file")))
            for frame in xml.parse(os.path.join(folder, "surface.pvd")).iter("DataSet")]


def arrays(data):
    return {data.GetArrayName(i): data.GetArray(i) for i in range(data.GetNumberOfArrays())}


def close(a, b, tolerance):
    assert abs(a - b) <= tolerance * max(abs(a), abs(b)), (a, b)


def corner_points(surface, cell):
    ids = surface.GetCell(cell).GetPointIds()
    return [surface.GetPoint(ids.GetId(i)) for i in range(ids.GetNumberOfIds())]


def area_vector(surface, cell):
    a, b, c = corner_points(surface, cell)
    u, v = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
    return [0.5 * (u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3]) for i in range(3)]


def check_units(fields):
    for name, unit in UNITS.items():
        if name in fields:
            information = fields[name].GetInformation()
            assert information.Get(vtkDataArray.UNITS_LABEL()) == unit, (name, information)


def check_double_bubble(folder):
    frames = series(folder)
    assert [time for time, _ in frames] == [0, 0.02, 0.04], frames
    surface = read(frames[-1][1])
    cells, points = arrays(surface.GetCellData()), arrays(surface.GetPointData())
    check_units({**cells, **points})
    assert set(cells) >= {"region_a", "region_b", "film", "circulation", "mean_curvature", "pressure_jump",
                          "sheet_strength"}, cells
    assert set(points) >= {"velocity", "normal", "border", "plateau_vertex", "held"}, points
    lines, triangles = surface.GetNumberOfLines(), surface.GetNumberOfPolys()
    assert lines >= 6 and all(math.isnan(cells["circulation"].GetValue(i)) for i in range(lines))

    area, films, flux, jumps = 0, {}, {}, {}
    for cell in range(lines, lines + triangles):
        a, b = cells["region_a"].GetValue(cell), cells["region_b"].GetValue(cell)
        assert 0 <= a < b <= 2, (a, b)
        films.setdefault((a, b), set()).add(cells["film"].GetValue(cell))
        size = math.sqrt(sum(x * x for x in area_vector(surface, cell)))
        area += size
        # The bubbles begin to move as their border draws together: of one sign all over a film.
        flux.setdefault((a, b), []).append(cells["circulation"].GetValue(cell))
        close(cells["pressure_jump"].GetValue(cell), 4 * cells["mean_curvature"].GetValue(cell), 1e-12)
        jumps.setdefault((a, b), []).append(cells["pressure_jump"].GetValue(cell))
    assert films == {(0, 1): {0}, (0, 2): {1}, (1, 2): {2}}, films
    with open(os.path.join(folder, "metrics.csv")) as table:
        close(area, float(list(csv.DictReader(table))[-1]["area"]), 1e-12)
    # By symmetry the outer films' circulations for (air, bubble) are the same, and one has not the sign of the other.
    means = [sum(flux[0, bubble]) / len(flux[0, bubble]) for bubble in (1, 2)]
    assert means[0] * means[1] > 0, means
    close(means[0], means[1], 0.01)
    # Oriented: from the air behind into a bubble in front, whose pressure is higher; between the two there is no jump.
    for bubble in (1, 2):
        assert sum(jumps[0, bubble]) / len(jumps[0, bubble]) < -2
    assert max(map(abs, jumps[1, 2])) < 0.1

    on_border = {surface.GetCell(i).GetPointId(end) for i in range(lines) for end in (0, 1)}
    flags = {v for v in range(surface.GetNumberOfPoints()) if points["border"].GetValue(v) == 1}
    assert flags == on_border and len(flags) == lines, "one closed border"
    assert points["plateau_vertex"].GetRange() == (0, 0)
    assert points["held"].GetRange() == (0, 0)
    assert points["velocity"].GetNumberOfComponents() == 3 and points["velocity"].GetRange(-1)[1] > 0


def check_ball(folder):
    surface = read(series(folder)[0][1])
    cells, points = arrays(surface.GetCellData()), arrays(surface.GetPointData())
    assert set(cells) == {"region_a", "region_b", "film", "mean_curvature", "pressure_jump"}, cells
    assert not points, points
    check_units(cells)
    for name, right in (("mean_curvature", -1), ("pressure_jump", -4)):
        values = [cells[name].GetValue(i) for i in range(cells[name].GetNumberOfTuples())]
        close(sum(values) / len(values), right, 0.01)
        assert max(values) < 0, name


check_double_bubble(sys.argv[1])
check_ball(sys.argv[2])
