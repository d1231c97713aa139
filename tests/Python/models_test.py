"""Effects, area strategies and scenes that Python wrote, chosen by name."""

import foamsim
import numpy as np
import pytest


class Wind(foamsim.Effect):
    attributes = {"soap": (1.0, "conserve"), "age": 0.0}

    def __init__(self, speed):
        self.speed, self.calls = speed, 0

    def add_velocity(self, step):
        return np.full_like(step.positions, self.speed) * [1, 0, 0]

    def update(self, step):
        self.calls += 1
        step.attributes["age"] += step.dt

    def state(self):
        return self.calls

    def restore(self, state):
        self.calls = state


def with_effect(make, name="mine", options=None, **others):
    catalogue = foamsim.Catalogue()
    catalogue.add_effect(name, make, "one of ours", options or {})
    return foamsim.Simulation("doublebubble", {"n": 8, "effects": [name], **others}, catalogue=catalogue)


def test_an_effect_moves_the_films():
    sim = with_effect(lambda options: Wind(options["wind"]), options={"wind": 2.0}, wind=3.0,
                      **{"remeshing.enabled": False})
    before = np.array(sim.mesh.positions)
    sim.step()
    assert np.allclose(sim.mesh.positions - before, [3 * sim.dt, 0, 0])


def test_its_attributes_are_views_and_follow_it():
    sim = with_effect(lambda options: Wind(0.0))
    sim.run(steps=2)
    attributes = sim.mesh.vertex_attributes
    assert np.allclose(attributes["age"][sim.mesh.vertex_alive], 2 * sim.dt)
    attributes["soap"][:] = 5
    assert (sim.mesh.vertex_attributes["soap"] == 5).all()


def test_its_state_is_in_checkpoints(tmp_path):
    made = []

    def make(options):
        made.append(Wind(1.0))
        return made[-1]

    catalogue = foamsim.Catalogue()
    catalogue.add_effect("mine", make)
    sim = foamsim.Simulation("doublebubble", n=8, effects="mine", catalogue=catalogue)
    sim.run(steps=3)
    sim.save(tmp_path / "a.cbor")
    foamsim.Simulation.resume(tmp_path / "a.cbor", catalogue)
    assert made[-1] is not made[0] and made[-1].calls == 3
    with pytest.raises(ValueError, match="mine"):
        foamsim.Simulation.resume(tmp_path / "a.cbor")


@pytest.mark.parametrize("hook", ["update", "add_velocity", "move_vertices", "displaced"])
def test_what_a_hook_raises_passes_and_the_step_is_undone(hook):
    def fail(self, step):
        raise ZeroDivisionError("mine")

    sim = with_effect(lambda options: type("Bad", (foamsim.Effect,), {hook: fail})())
    before = np.array(sim.mesh.positions)
    with pytest.raises(ZeroDivisionError, match="mine"):
        sim.step()
    assert sim.steps == 0 and np.array_equal(before, sim.mesh.positions)


@pytest.mark.parametrize("hook", ["add_velocity", "move_vertices", "displaced"])
@pytest.mark.parametrize("given", [np.zeros((3, 3)), np.zeros(7), "words"])
def test_rows_that_do_not_fit_are_refused(hook, given):
    sim = with_effect(lambda options: type("Bad", (foamsim.Effect,), {hook: lambda self, step: given})())
    with pytest.raises(ValueError, match=hook):
        sim.step()
    assert sim.steps == 0


def test_a_bubble_bursts_when_an_effect_says_so():
    class Pin(foamsim.Effect):
        lets_burst = True
        pending = []

        def bursts(self, step):
            regions, Pin.pending = Pin.pending, []
            return regions

    sim = with_effect(lambda options: Pin())
    sim.step()
    assert sorted(sim.metrics()["volumes"]) == [0, 1, 2]
    Pin.pending = [2]
    sim.step()
    assert sorted(sim.metrics()["volumes"]) == [0, 1]
    Pin.pending = [7]
    with pytest.raises(ValueError, match="no region 7"):
        sim.step()


def with_area(strategy):
    catalogue = foamsim.Catalogue()
    catalogue.add_area("mine", lambda options: strategy)
    return foamsim.Simulation("doublebubble", n=8, area="mine", catalogue=catalogue)


def test_an_area_strategy_equals_the_one_that_it_copies():
    sim, naive = with_area(lambda star: star.own_areas), foamsim.Simulation("doublebubble", n=8, area="naive")
    sim.step()
    naive.step()
    assert np.array_equal(sim.mesh.positions, naive.mesh.positions)


@pytest.mark.parametrize("strategy", [lambda star: [1.0] * 9, lambda star: None, lambda star: [-1.0] * len(star.regions)])
def test_areas_that_do_not_fit_are_refused(strategy):
    sim = with_area(strategy)
    with pytest.raises(ValueError, match="area strategy 'mine'"):
        sim.step()
    assert sim.steps == 0


def test_what_an_area_strategy_raises_passes():
    sim = with_area(lambda star: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        sim.step()


def tetrahedron(options):
    x = options["edge"] * np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], float)
    return x, [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]], [[1, 0]] * 4


def test_a_scene_by_name():
    catalogue = foamsim.Catalogue()
    catalogue.add_scene("four", tetrahedron, "four films", {"edge": 1.0})
    assert catalogue.scenes["four"] == "four films"
    sim = foamsim.Simulation("four", edge=2.0, catalogue=catalogue)
    assert sim.mesh.positions.max() == 2.0


def test_a_scene_without_films_is_refused():
    catalogue = foamsim.Catalogue()
    catalogue.add_scene("none", lambda options: 5)
    with pytest.raises(ValueError, match="positions, triangles, labels"):
        foamsim.Simulation("none", catalogue=catalogue)


def test_names_are_taken_once():
    with pytest.raises(ValueError, match="diffusion"):
        foamsim.Catalogue().add_effect("diffusion", lambda options: foamsim.Effect())
