"""Mesh files and pictures."""

import foamsim
import numpy as np
import pytest

X = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], float)
T = np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])
L = np.array([[1, 0]] * 4)


@pytest.mark.parametrize("name", ["a.ply", "a.rec", "a.vtp"])
def test_a_surface_comes_back_from_a_file(tmp_path, name):
    foamsim.write_mesh(tmp_path / name, X, T, L)
    x, triangles, labels = foamsim.read_mesh(tmp_path / name)
    assert np.array_equal(x, X) and np.array_equal(triangles, T) and np.array_equal(labels, L)


@pytest.mark.parametrize("surface, words", [
    ((X[:, :2], T, L), "positions"),
    ((X, T + 1, L), "4"),
    ((X, T - 1, L), "triangles"),
    ((X, T, L[:2]), "labels"),
    ((X * np.nan, T, L), "finite"),
    ((["a"], T, L), "positions"),
])
def test_what_is_no_surface_is_refused_and_nothing_written(tmp_path, surface, words):
    with pytest.raises(ValueError, match=words):
        foamsim.write_mesh(tmp_path / "a.ply", *surface)
    assert not (tmp_path / "a.ply").exists()


def test_an_unknown_extension_and_an_absent_file_are_value_errors(tmp_path):
    with pytest.raises(ValueError, match="a.what"):
        foamsim.write_mesh(tmp_path / "a.what", X, T, L)
    with pytest.raises(ValueError, match="absent.ply"):
        foamsim.read_mesh(tmp_path / "absent.ply")


def test_a_simulation_writes_its_fields(tmp_path):
    sim = foamsim.Simulation("doublebubble", n=8)
    sim.step()
    sim.write(tmp_path / "a.vtp")
    assert "circulation" in (tmp_path / "a.vtp").read_bytes().decode("latin-1")


def test_a_picture_is_an_array():
    sim = foamsim.Simulation("doublebubble", n=8)
    image = sim.render(width=40, height=30, samples=1)
    assert image.shape == (30, 40, 3) and image.dtype == np.uint8 and image.std() > 0
    clear = foamsim.render(X, T, L, width=40, height=30, samples=1, background="transparent")
    assert clear.shape == (30, 40, 4) and clear[0, 0, 3] == 0


@pytest.mark.parametrize("look, words", [({"width": 0}, "width|size"), ({"height": 0}, "height"),
                                         ({"background": "blue"}, "blue"), ({"hidden": [True]}, "")])
def test_a_picture_that_cannot_be_made_is_refused(look, words):
    with pytest.raises(ValueError, match=words):
        foamsim.render(X, T, L, **{"width": 40, "height": 30, "samples": 1, **look})
