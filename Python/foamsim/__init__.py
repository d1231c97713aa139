"""Soap films and foams: scenes, steps, surfaces as NumPy arrays, pictures, and models written in Python.

    import foamsim
    sim = foamsim.Simulation("doublebubble", n=16)
    sim.run(steps=10, callback=lambda s: print(s.time, s.metrics()["area"]))

Bad input raises InputError, a ValueError, with the line that the program `foamsim` prints.
"""

import math as _math
import os as _os

from . import _foamsim
from ._foamsim import Error, InputError, __version__
from .effect import Effect
from .pin import Pin as _Pin

for _error in (Error, InputError):
    _error.__module__ = __name__

__all__ = ["Catalogue", "Effect", "Error", "InputError", "Mesh", "Simulation", "read_mesh", "render", "write_mesh"]


class Catalogue(_foamsim.Catalogue):
    """What is chosen by name: that of the library, with models of one's own added.

    `scenes`, `effects`, `areas`, `constraints`, `integrators`, `dynamics` are dicts, name -> one line;
    `options(scene)` is a dict, key -> (default, one line).

    `add_effect(name, make, summary="", options={})`: `make(options)` returns an Effect, `options` being a dict of all
    options of the scene, among them its own: numbers with their defaults.
    `add_area(name, make, ...)`: `make(options)` returns a function of a star (`vertex`, `position`, `regions`,
    `junction`, `own_areas`: a third of each region's triangles, L^2), which returns one area a region.
    `add_scene(name, build, ...)`: `build(options)` returns (positions, triangles, labels).
    """

    def __init__(self):
        super().__init__()
        self.add_effect("pin", _Pin, "bursts the region that it is told to, see Simulation.burst", {"pin": 0})


class Mesh:
    """The surface of a simulation, as it is when it is asked.

    `positions`, `triangles` and attributes are views without copies, by slot: rows of elements that are gone remain
    until they are used again (`vertex_alive`, `triangle_alive`). As long as any view, or a slice of it, is there,
    `Simulation.step` raises Error and changes nothing: drop the views, or keep copies, `numpy.array(mesh.positions)`.
    A view keeps the memory that it looks into, also behind the end of its simulation; after `Simulation.set` it shows
    the surface of before.
    """

    def __init__(self, view):
        self._view = view

    @property
    def positions(self):
        """(slots, 3), float64, L: a view, not to be written to."""
        return self._view.positions

    @property
    def triangles(self):
        """(slots, 3), uint32, numbers of vertex slots: a view, not to be written to."""
        return self._view.triangles

    @property
    def labels(self):
        """(slots, 2), uint32: the regions behind and in front of each triangle. A copy."""
        return self._view.labels

    @property
    def vertex_alive(self):
        """(slots,), bool. A copy."""
        return self._view.vertex_alive

    @property
    def triangle_alive(self):
        """(slots,), bool. A copy."""
        return self._view.triangle_alive

    @property
    def vertex_attributes(self):
        """Name -> view of the named numbers and vectors at the vertices. What is written there goes into the next step."""
        return self._view.vertex_attributes

    @property
    def triangle_attributes(self):
        """The same at the triangles."""
        return self._view.triangle_attributes

    @property
    def solid(self):
        """Which living triangles are of a solid, bool. A copy, in the order of `compact`."""
        return self._view.solid

    def compact(self):
        """(positions, triangles, labels) of what is alive, numbered without gaps: copies."""
        return self._view.compact()


def _number(text):
    if text == "":
        return None
    try:
        return int(text)
    except ValueError:
        return float(text)


def _paths(path):
    return _os.fsdecode(_os.fspath(path))


class Simulation(_foamsim.Simulation):
    """A scene on its way.

    `scene`: a built-in scene, one of the catalogue, a .toml scene file, an option file, or a mesh file. Options are
    keywords, with `__` for a point in a key (`remeshing__enabled=True`), or a dict `options`.

    `steps`, `time` and `dt` (T), `resolution` (L), `scene`, `options` (a dict of all), `at_rest` say how it is.
    """

    def __init__(self, scene, options=None, catalogue=None, **keywords):
        given = dict(options or {})
        given.update((key.replace("__", "."), value) for key, value in keywords.items())
        super().__init__(_paths(scene), given, catalogue or Catalogue())

    @classmethod
    def resume(cls, checkpoint, catalogue=None):
        """Goes on from a checkpoint, or from that in the folder of a run, to the bit as if it had not stopped."""
        path = _paths(checkpoint)
        if _os.path.isdir(path):
            path = _os.path.join(path, "checkpoint.cbor")
        self = cls.__new__(cls)
        _foamsim.Simulation.__init__(self, path, catalogue or Catalogue())
        return self

    def run(self, steps=None, time=None, callback=None):
        """Makes `steps` steps, or those up to `time` (T), or up to the scene's own time.

        `callback(simulation)` is called after each; when it returns False the run is over. What it raises passes through,
        with the last whole step's state kept, and so does Ctrl-C, also within a step, which is then undone.
        """
        if steps is None:
            end = self.get("time") if time is None else time
            if not (_math.isfinite(end) and end >= 0):
                raise InputError("run: time has to be a finite number >= 0")
            steps = round(end / self.dt) - self.steps
        elif time is not None:
            raise InputError("run: give steps or time, not both")
        elif steps < 0:
            raise InputError("run: steps has to be a whole number >= 0")
        for _ in range(steps):
            self.step()
            if callback is not None and callback(self) is False:
                return

    def burst(self, region):
        """Lets a region burst as the next step begins. Adds the effect `pin`, which only this package has."""
        living = set(self.mesh.compact()[2].flat) - {0}
        if region not in living:
            raise InputError(f"burst: the surface has no region {region} that could burst")
        if "pin" not in self.get("effects"):
            self.set("effects", [*self.get("effects"), "pin"])
        elif self.get("pin") in living:
            raise InputError(f"burst: region {self.get('pin'):.0f} bursts in the next step; make that first")
        self.set("pin", int(region))

    def refine(self, factor=2):
        """Divides the resolution, to which the next steps remesh where remeshing is enabled; below 1 it gets coarser."""
        if not (_math.isfinite(factor) and factor > 0):
            raise InputError("refine: the factor has to be a finite number > 0")
        self.set("resolution", self.resolution / factor)

    @property
    def mesh(self):
        """The surface, a Mesh."""
        return Mesh(super().mesh)

    def metrics(self):
        """The columns of metrics.csv for the last step (docs/output.md), None where there is no value, and `volumes`:
        region -> volume (L^3), that of the air, 0, as in volumes.csv."""
        header, row, volumes = self._metrics()
        values = dict(zip(header.strip().split(","), map(_number, row.strip("\n").split(","))))
        values["volumes"] = volumes
        return values

    def render(self, **look):
        """A picture of the films without solids, see `render`."""
        view = super().mesh
        return render(*view.compact(), hidden=view.solid, **look)

    def write(self, path):
        """Writes the surface in the format of the path's extension; .vtp with all fields, .rec with circulation."""
        super().write(_paths(path))

    def save(self, checkpoint):
        """Writes a checkpoint, for `resume` and for `foamsim run --resume`."""
        super().save(_paths(checkpoint))


def read_mesh(path):
    """(positions, triangles, labels) of a mesh file in any format that `foamsim convert` reads."""
    return _foamsim.read_mesh(_paths(path))


def write_mesh(path, positions, triangles, labels):
    """Writes a mesh file in the format of the path's extension."""
    _foamsim.write_mesh(_paths(path), positions, triangles, labels)


def render(positions, triangles, labels, hidden=(), width=800, height=600, samples=16, background="dark",
           direction=(0.514, 0.242, 0.823)):
    """A picture of films: (height, width, 3), uint8, sRGB; with the background "transparent" (height, width, 4).

    `hidden`: one flag a triangle, true for those that are left out; `samples`: rays a pixel; `background`: "dark",
    "white" or "transparent"; `direction`: from the films towards the eye.
    """
    return _foamsim.render(positions, triangles, labels, list(hidden), width, height, samples, background,
                           tuple(direction))
