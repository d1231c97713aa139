"""Views of the surface: what they show, how long, and what they forbid."""

import gc

import foamsim
import numpy as np
import pytest


def small():
    return foamsim.Simulation("doublebubble", n=8)


def test_positions_and_triangles_are_views_without_copies():
    mesh = small().mesh
    assert np.shares_memory(mesh.positions, mesh.positions)
    assert np.shares_memory(mesh.triangles, mesh.triangles)
    assert mesh.positions.shape[1] == 3 and mesh.positions.dtype == np.float64
    assert mesh.triangles.shape == (len(mesh.labels), 3)


def test_views_cannot_be_written_to():
    with pytest.raises(ValueError, match="read-only"):
        small().mesh.positions[0, 0] = 1


def test_a_step_is_refused_while_a_view_or_a_slice_of_one_is_there():
    sim = small()
    row = sim.mesh.positions[3]
    with pytest.raises(foamsim.Error, match="copies"):
        sim.step()
    assert sim.steps == 0
    del row
    sim.step()
    assert sim.steps == 1


def test_a_copy_does_not_hinder():
    sim = small()
    kept = np.array(sim.mesh.positions)
    sim.step()
    assert len(kept) > 0


def test_a_view_outlives_its_simulation():
    sim = small()
    view, copy = sim.mesh.positions, np.array(sim.mesh.positions)
    del sim
    gc.collect()
    assert np.array_equal(view, copy)


def test_a_view_of_before_an_option_was_set_stays_as_it_was():
    sim = small()
    view, copy = sim.mesh.positions, np.array(sim.mesh.positions)
    sim.set("sigma", 2.0)
    sim.step()
    assert np.array_equal(view, copy)


def test_what_is_alive_without_gaps_is_what_is_written(tmp_path):
    sim = small()
    x, triangles, labels = sim.mesh.compact()
    assert len(x) == sim.mesh.vertex_alive.sum() and len(triangles) == sim.mesh.triangle_alive.sum()
    sim.write(tmp_path / "a.ply")
    read = foamsim.read_mesh(tmp_path / "a.ply")
    assert np.array_equal(read[0], x) and np.array_equal(read[1], triangles) and np.array_equal(read[2], labels)


def test_a_simulation_is_not_used_while_it_makes_a_step():
    catalogue = foamsim.Catalogue()
    held = []

    class Meddler(foamsim.Effect):
        def add_velocity(self, step):
            held[0].step()

    catalogue.add_effect("meddler", lambda options: Meddler())
    held.append(foamsim.Simulation("doublebubble", n=8, effects=["meddler"], catalogue=catalogue))
    with pytest.raises(foamsim.Error, match="step is being made"):
        held[0].step()
    assert held[0].steps == 0
