"""What Simulation.burst uses."""

from .effect import Effect


class Pin(Effect):
    """Bursts the region that the option `pin` names, once; regions that are gone are never there again."""

    lets_burst = True

    def __init__(self, options):
        self.region, self.done = int(options["pin"]), []

    def bursts(self, step):
        if self.region == 0 or self.region in self.done:
            return None
        self.done = self.done + [self.region]
        return [self.region]

    def state(self):
        return self.done

    def restore(self, state):
        self.done = state or []
