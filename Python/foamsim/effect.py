"""The base of effects that are written in Python."""


class Effect:
    """Something that acts on the films; derive from it, and give a function that makes it to Catalogue.add_effect.

    Hooks get a `step`: `time` and `dt` (T), `positions` ((n, 3), L, one row a vertex slot), `triangles` ((m, 3), numbers
    of slots) and `labels` ((m, 2), the regions behind and in front). These are copies, to keep or to change. A hook that
    raises ends the step, which is undone.
    """

    #: Named numbers at the vertices: name -> initial value, or (initial value, how it is carried when the mesh changes:
    #: "interpolate", "copy" or "conserve"). They are written to .vtp files and are in checkpoints.
    attributes = {}
    #: Whether `bursts` is asked.
    lets_burst = False

    def bursts(self, step):
        """Regions that burst as the step begins: a list of numbers, or None."""

    def displaced(self, step):
        """Where vertices go before the step, as far as nothing intersects: (n, 3), L, or None."""

    def update(self, step):
        """Once a step, before velocities are evaluated: writes into the arrays `step.attributes`."""

    def add_velocity(self, step):
        """What to add to the vertices' velocities at a stage of the step: (n, 3), L/T, or None."""

    def add_force(self, step):
        """The gradient of its potential energy, for dynamics that take forces: (n, 3), L^4/T^2, or None."""

    def move_vertices(self, step):
        """Where the vertices are put in the place of `step.positions`: (n, 3), L, or None. Held vertices stay held."""

    def potential_energy(self, step):
        """Potential energy over air density, L^5/T^2."""
        return 0.0

    def state(self):
        """What it remembers from step to step, as JSON has it: kept in checkpoints, put back when a step fails."""
        return None

    def restore(self, state):
        """Takes back what `state` gave."""
