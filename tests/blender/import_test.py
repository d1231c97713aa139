"""Runs in Blender: a run's frames, and the same as .obj, are imported and looked at, and motion blur is rendered."""

import os
import pathlib
import shutil
import subprocess
import sys

import bpy
import numpy as np

sys.path.insert(0, os.environ["EXAMPLES"])
import import_foam  # noqa: E402

FOAMSIM = os.environ["FOAMSIM"]
SCRATCH = pathlib.Path(os.environ["SCRATCH"])
SPEED, DT, FPS = 0.5, 0.02, 20


def foamsim(*words):
    subprocess.run([FOAMSIM, *map(str, words)], check=True, stdout=subprocess.DEVNULL)


def values(mesh, name):
    attribute = mesh.attributes[name]
    is_vector = attribute.data_type == "FLOAT_VECTOR"
    numbers = np.empty(len(attribute.data) * (3 if is_vector else 1), dtype=np.float32 if is_vector else np.int32)
    attribute.data.foreach_get("vector" if is_vector else "value", numbers)
    return numbers.reshape(-1, 3) if is_vector else numbers


def positions(mesh):
    numbers = np.empty(3 * len(mesh.vertices), dtype=np.float32)
    mesh.vertices.foreach_get("co", numbers)
    return numbers.reshape(-1, 3)


def check_run(run):
    """Two bubbles that fly towards each other along x: both ways to read them, and what they say of the motion."""
    objects = import_foam.import_foam([run], fps=FPS)
    assert len(objects) == 6, objects
    foamsim("convert", run / "frames" / "frame_*.ply", SCRATCH / "objs" / "f*.obj")
    from_objs = import_foam.import_foam(sorted((SCRATCH / "objs").glob("f*.obj")), frame_time=DT, fps=FPS)
    for ours, other in zip(objects, from_objs):
        assert np.array_equal(positions(ours.data), positions(other.data))
        assert np.array_equal(values(ours.data, "vertex_id"), values(other.data, "vertex_id"))
        assert np.allclose(values(ours.data, "velocity"), values(other.data, "velocity"))
        # Film by film in an .obj, and turned there: the same films all the same.
        for name in ("region_a", "region_b"):
            assert set(values(ours.data, name)) <= {0, 1, 2}
        areas = [sum(p.area for p in thing.data.polygons) for thing in (ours, other)]
        assert abs(areas[0] / areas[1] - 1) < 1e-6, areas
    for before, after in zip(objects, objects[1:]):
        check_motion(before.data, after.data)


def check_motion(before, after):
    ids, was = values(after, "vertex_id"), values(before, "vertex_id")
    assert len(set(ids)) == len(ids)
    common, now, then = np.intersect1d(ids, was, return_indices=True)
    assert len(common) > 0.9 * len(ids), (len(common), len(ids))
    moved = positions(after)[now] - positions(before)[then]
    # One frame of the film shows DT, a second FPS of them.
    velocity = values(after, "velocity")[now] / FPS
    off = np.linalg.norm(moved - velocity, axis=1)
    assert np.median(off) < 0.02 * np.median(np.linalg.norm(velocity, axis=1)), np.median(off)
    x, u = positions(after), values(after, "velocity")
    assert u[x[:, 0] < 0, 0].mean() > 0 > u[x[:, 0] > 0, 0].mean()


def check_seen_once(objects):
    for number in range(1, len(objects) + 1):
        bpy.context.scene.frame_set(number)
        seen = [thing for thing in objects if not thing.hide_render]
        assert seen == [objects[number - 1]], (number, seen)


def check_normals(mesh):
    """Of an ellipsoid along the axes, at every corner."""
    mesh.calc_normals_split()
    x = positions(mesh)
    exact = x / np.ptp(x, axis=0) ** 2
    exact /= np.linalg.norm(exact, axis=1, keepdims=True)
    for loop in mesh.loops:
        assert abs(abs(np.dot(exact[loop.vertex_index], loop.normal)) - 1) < 0.02


def ellipsoid_that_flies(speed):
    """A frame of the start of the scene sphere that goes along x, in lengths a unit of time."""
    foamsim("run", "sphere", "--set", "n=2", "--steps", 0, "--force", "--out", SCRATCH / "sphere")
    frame = import_foam.read_frame(SCRATCH / "sphere" / "frames" / "frame_000000.ply")
    frame.point_values["velocity"] = np.tile([speed, 0.0, 0.0], (len(frame.positions), 1))
    return frame


def render(blur):
    """The opacity of each pixel, of a view along y that is six lengths wide."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.seed, scene.cycles.use_denoising = 64, 1, False
    scene.render.resolution_x, scene.render.resolution_y = 60, 40
    scene.render.film_transparent, scene.render.use_motion_blur = True, blur
    scene.render.motion_blur_shutter = 1.0
    scene.render.image_settings.color_mode = "RGBA"
    scene.render.filepath = str(SCRATCH / f"blur_{int(blur)}.png")
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    return np.array(image.pixels[:]).reshape(40, 60, 4)[:, :, 3]


def check_blur():
    """In the time that the shutter is open it flies 2 lengths: what is seen is so much wider, and fainter at its ends."""
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    scene = bpy.context.scene
    scene.render.fps = FPS
    thing = bpy.data.objects.new("sphere", import_foam.make_mesh("sphere", ellipsoid_that_flies(2.0), FPS))
    scene.collection.objects.link(thing)
    material = bpy.data.materials.new("solid")
    thing.data.materials.append(material)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type, camera.data.ortho_scale = "ORTHO", 6
    camera.location, camera.rotation_euler = (0, -5, 0), (np.pi / 2, 0, 0)
    scene.collection.objects.link(camera)
    scene.camera = camera
    rows = [render(blur)[18:22].mean(axis=0) for blur in (False, True)]
    widths = [(row > 0.02).sum() / 10 for row in rows]
    diameter = np.ptp(positions(thing.data)[:, 0])
    assert abs(widths[0] - diameter) < 0.25, (widths, diameter)
    assert abs(widths[1] - diameter - 2) < 0.45, (widths, diameter)
    # The middle is covered for a part of the time only.
    assert rows[0][29:31].min() > 0.95 > rows[1][29:31].max(), rows


def main():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    run = SCRATCH / "headon"
    foamsim("run", "headon", "--set", "n=2", "--set", f"speed={SPEED}", "--set", f"dt={DT}", "--set", "gap=2", "--set",
            "frame_every=1", "--set", "frame_motion=true", "--steps", 5, "--out", run)
    check_run(run)
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    check_seen_once(import_foam.import_foam([run], fps=FPS))
    check_blur()
    foam = import_foam.import_foam([SCRATCH / "sphere"])
    check_normals(foam[0].data)


main()
