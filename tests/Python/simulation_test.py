"""Scenes, options, steps, checkpoints, and how a run is stopped."""

import os
import runpy
import signal
import threading

import foamsim
import numpy as np
import pytest


def positions(sim):
    return np.array(sim.mesh.positions)


def test_a_step_moves_the_films_and_counts():
    sim = foamsim.Simulation("doublebubble", n=8)
    before = positions(sim)
    sim.step()
    assert sim.steps == 1
    assert sim.time == pytest.approx(sim.dt)
    assert not np.array_equal(before, positions(sim))


def test_metrics_are_the_columns_of_the_table():
    sim = foamsim.Simulation("doublebubble", n=8)
    sim.run(steps=2)
    metrics = sim.metrics()
    assert metrics["step"] == 2 and isinstance(metrics["step"], int)
    assert metrics["area"] > 0 and metrics["triangles"] == len(sim.mesh.compact()[1])
    assert sorted(metrics["volumes"]) == [0, 1, 2]


def test_options_are_those_of_the_program():
    sim = foamsim.Simulation("doublebubble", {"n": 8, "effects": ["surface_tension"]}, remeshing__enabled=True, dt=0.005)
    assert sim.dt == 0.005
    assert sim.get("remeshing.enabled") is True
    assert sim.options["effects"] == ["surface_tension"]
    assert foamsim.Catalogue().options("doublebubble")["n"][0] == 16


@pytest.mark.parametrize("scene, options, words", [
    ("dubblebubble", {}, "doublebubble"),
    ("doublebubble", {"sigme": 1}, "sigma"),
    ("doublebubble", {"sigma": -1}, "sigma"),
    ("doublebubble", {"n": 8.5}, "n"),
    ("doublebubble", {"area": "avaraged"}, "averaged"),
    ("doublebubble", {"sigma": object()}, "sigma"),
    ("doublebubble", {"n": 10**30}, "n"),
    ("nothing.ply", {}, "nothing.ply"),
])
def test_what_is_wrong_is_a_value_error_of_one_line(scene, options, words):
    with pytest.raises(ValueError) as error:
        foamsim.Simulation(scene, options)
    assert words in str(error.value) and "\n" not in str(error.value)


def test_a_resumed_simulation_goes_on_to_the_bit(tmp_path):
    sim = foamsim.Simulation("doublebubble", n=8)
    sim.run(steps=2)
    sim.save(tmp_path / "a.cbor")
    again = foamsim.Simulation.resume(tmp_path / "a.cbor")
    assert again.steps == 2
    sim.run(steps=2)
    again.run(steps=2)
    assert np.array_equal(positions(sim), positions(again))


def test_a_file_that_is_no_checkpoint_is_named(tmp_path):
    (tmp_path / "b.cbor").write_bytes(b"nothing")
    with pytest.raises(ValueError, match="b.cbor"):
        foamsim.Simulation.resume(tmp_path / "b.cbor")
    with pytest.raises(ValueError, match="absent"):
        foamsim.Simulation.resume(tmp_path / "absent")


def test_an_option_that_is_set_acts_from_then_on():
    sim, other = foamsim.Simulation("doublebubble", n=8), foamsim.Simulation("doublebubble", n=8)
    for each in (sim, other):
        each.run(steps=2)
    before = positions(sim)
    sim.set("sigma", 2.0)
    assert sim.steps == 2 and sim.get("sigma") == 2.0
    assert np.array_equal(before, positions(sim))
    for each in (sim, other):
        each.step()
        each.step()
    assert not np.array_equal(positions(sim), positions(other))


def test_a_finer_resolution_gives_more_triangles():
    sim = foamsim.Simulation("doublebubble", n=8)
    sim.step()
    before, h = len(sim.mesh.compact()[1]), sim.resolution
    sim.refine()
    assert sim.resolution == h / 2 and sim.steps == 1
    sim.run(steps=2)
    assert len(sim.mesh.compact()[1]) > 2 * before
    with pytest.raises(ValueError, match="resolution"):
        sim.set("resolution", 1e-9)
    with pytest.raises(ValueError, match="factor"):
        sim.refine(0)


def test_a_bubble_bursts_on_request(tmp_path):
    sim = foamsim.Simulation("doublebubble", n=8)
    sim.step()
    sim.burst(2)
    assert sorted(sim.metrics()["volumes"]) == [0, 1, 2]
    sim.save(tmp_path / "a.cbor")
    sim.step()
    assert sorted(sim.metrics()["volumes"]) == [0, 1]
    sim.run(steps=2)
    again = foamsim.Simulation.resume(tmp_path / "a.cbor")
    again.run(steps=3)
    assert np.array_equal(positions(sim), positions(again))
    for region in (0, 2, 7):
        with pytest.raises(ValueError, match="region"):
            sim.burst(region)
    sim.step()


def test_an_option_that_cannot_be_set_changes_nothing():
    sim, other = foamsim.Simulation("doublebubble", n=8), foamsim.Simulation("doublebubble", n=8)
    for key, value in (("sigma", -1), ("nothing", 1), ("dt", 0.5)):
        with pytest.raises(ValueError, match=key):
            sim.set(key, value)
    for each in (sim, other):
        each.run(steps=2)
    assert np.array_equal(positions(sim), positions(other))


def test_run_calls_back_after_every_step_until_it_hears_false():
    sim = foamsim.Simulation("doublebubble", n=8)
    seen = []
    sim.run(steps=5, callback=lambda s: seen.append(s.steps) or len(seen) < 3)
    assert seen == [1, 2, 3] and sim.steps == 3
    sim.run(time=5 * sim.dt)
    assert sim.steps == 5
    sim.run(time=0)
    assert sim.steps == 5


@pytest.mark.parametrize("how", [{"steps": -1}, {"time": float("nan")}, {"time": -1.0}, {"steps": 1, "time": 1.0}])
def test_run_refuses_what_is_no_length(how):
    with pytest.raises(ValueError, match="run"):
        foamsim.Simulation("doublebubble", n=8).run(**how)


def test_what_a_callback_raises_passes_and_the_last_whole_step_stays():
    sim, other = foamsim.Simulation("doublebubble", n=8), foamsim.Simulation("doublebubble", n=8)

    def fail(s):
        if s.steps == 2:
            raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        sim.run(steps=5, callback=fail)
    assert sim.steps == 2
    other.run(steps=2)
    assert np.array_equal(positions(sim), positions(other))


def test_ctrl_c_stops_within_a_step_which_is_undone():
    sim = foamsim.Simulation("doublebubble", n=48)
    before = positions(sim)
    timer = threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT))
    with pytest.raises(KeyboardInterrupt):
        timer.start()
        sim.run(steps=1000)
    timer.join()
    assert sim.steps < 1000
    if sim.steps == 0:
        assert np.array_equal(before, positions(sim))
    sim.step()


def test_other_threads_run_while_a_step_is_made():
    sim = foamsim.Simulation("doublebubble", n=24)
    ticks, done = [], threading.Event()

    def tick():
        while not done.wait(0.001):
            ticks.append(1)

    thread = threading.Thread(target=tick)
    thread.start()
    sim.run(steps=1)
    made_within = len(ticks)
    done.set()
    thread.join()
    assert made_within > 0


def test_the_page_runs_as_it_stands(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with open(os.environ["FOAMSIM_PAGE"], encoding="utf-8") as page:
        code = "\n".join(block.split("```")[0] for block in page.read().split("```python\n")[1:])
    names = {}
    exec(compile(code, "python.md", "exec"), names)
    assert names["image"].shape == (300, 400, 3)
    assert names["again"].steps == 21 and (tmp_path / "bubbles.vtp").exists()


def test_the_example_prints_the_first_rows_of_table_1(capsys):
    runpy.run_path(os.path.join(os.environ["FOAMSIM_EXAMPLES"], "table1_first_rows.py"), run_name="__main__")
    rows = capsys.readouterr().out.strip().splitlines()
    assert [row.split()[:3] for row in rows] == [["averaged", "1048", "13.01"], ["constant-edge", "1104", "30.20"]]
