"""Puts the frames of a run into Blender, a mesh a frame, with what motion blur needs.

    blender --python import_foam.py -- out/run [--fps 24] [--every 1]
    blender --python import_foam.py -- frame_*.ply --frame-time 0.25
    blender --background --python import_foam.py -- out/run --view 960x540 --save foam.blend

A folder of a run, or .ply and .obj files in the order of the film. Each becomes an object of the collection "foam" that is
seen in one frame of the film alone. Meshes have the attributes

    velocity    points, in lengths a second of the film: Cycles blurs by it (Render Properties, Motion Blur)
    vertex_id   points: numbers that vertices keep in all frames
    region_a, region_b, solid    faces

of which the first two are there where the run was made with `frame_motion=true`. Films are shaded smoothly, each for itself.
`--view` makes a new scene with a camera that sees all frames and a sky, and sets up Cycles with motion blur; `--save` writes the .blend file.
Needs Blender 3.1 or later, with numpy.
"""

import argparse
import json
import pathlib
import re
import sys

import bpy
import mathutils
import numpy as np

PLY_TYPES = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
             "float": "f4", "double": "f8"}


class Frame:
    """A surface with what its file says of vertices and faces, by name."""

    def __init__(self, positions, triangles, point_values, face_values):
        self.positions = positions        # n x 3
        self.triangles = triangles        # m x 3
        self.point_values = point_values  # velocity: n x 3 (L/T), vertex_id: n
        self.face_values = face_values    # region_a, region_b, solid: m


def read_ply(path):
    """A frame as foamsim writes it: binary, little-endian, triangles alone."""
    content = path.read_bytes()
    head, _, body = content.partition(b"end_header\n")
    lines = head.decode("ascii").split("\n")
    if lines[0] != "ply" or "format binary_little_endian 1.0" not in lines:
        raise ValueError(f"{path}: no frame of foamsim's; foamsim convert makes one of any surface")
    counts, layouts = {}, {}
    for line in lines:
        words = line.split()
        if words[:1] == ["element"]:
            element, counts[words[1]], layouts[words[1]] = words[1], int(words[2]), []
        elif words[:2] == ["property", "list"]:
            layouts[element] += [("corners", "u1"), (words[4], "<i4", 3)]
        elif words[:1] == ["property"]:
            layouts[element].append((words[2], "<" + PLY_TYPES[words[1]]))
    vertex, face = np.dtype(layouts["vertex"]), np.dtype(layouts["face"])
    points = np.frombuffer(body, vertex, counts["vertex"])
    faces = np.frombuffer(body, face, counts["face"], offset=points.nbytes)
    columns = lambda *names: np.stack([points[name] for name in names], axis=1)
    point_values = {}
    if "vx" in vertex.names:
        point_values["velocity"] = columns("vx", "vy", "vz")
    if "vertex_id" in vertex.names:
        point_values["vertex_id"] = points["vertex_id"]
    face_values = {name: faces[name] for name in ("region_a", "region_b", "solid") if name in face.names}
    return Frame(columns("x", "y", "z"), faces["vertex_indices"], point_values, face_values)


def read_obj(path):
    """An .obj as foamsim writes it: groups region_P_Q, velocities and ids as comments behind the vertices."""
    numbers = {"v": [], "#velocity": [], "#vertex_id": []}
    triangles, regions, region = [], [], (1, 0)
    for line in path.read_text().splitlines():
        word, _, rest = line.partition(" ")
        if word in numbers:
            numbers[word].append([float(x) for x in rest.split()])
        elif word == "g":
            named = re.match(r"region_(\d+)_(\d+)", rest)
            region = (int(named[1]), int(named[2])) if named else (1, 0)
        elif word == "f":
            triangles.append([int(corner.split("/")[0]) - 1 for corner in rest.split()])
            regions.append(region)
    point_values = {}
    if numbers["#velocity"]:
        point_values["velocity"] = np.array(numbers["#velocity"])
    if numbers["#vertex_id"]:
        point_values["vertex_id"] = np.array(numbers["#vertex_id"], dtype=np.int32).ravel()
    regions = np.array(regions, dtype=np.int32).reshape(-1, 2)
    return Frame(np.array(numbers["v"]).reshape(-1, 3), np.array(triangles, dtype=np.int32).reshape(-1, 3), point_values,
                 {"region_a": regions[:, 0], "region_b": regions[:, 1]})


def read_frame(path):
    readers = {".ply": read_ply, ".obj": read_obj}
    if path.suffix not in readers:
        raise ValueError(f"{path}: frames are .ply or .obj")
    return readers[path.suffix](path)


def corner_normals(frame):
    """Of every corner of every face: the mean over its vertex's faces that are of the same two regions, by area."""
    a, b, c = (frame.positions[frame.triangles[:, i]] for i in range(3))
    across = np.cross(b - a, c - a)
    pairs = np.stack([frame.face_values["region_a"], frame.face_values["region_b"]], axis=1)
    side = np.where(pairs[:, :1] < pairs[:, 1:], 1.0, -1.0)
    film = np.unique(np.sort(pairs, axis=1), axis=0, return_inverse=True)[1].ravel()
    keys = frame.triangles.astype(np.int64) + len(frame.positions) * film[:, None]
    places = np.unique(keys, return_inverse=True)[1].reshape(keys.shape)
    sums = np.zeros((places.max() + 1, 3))
    for i in range(3):
        np.add.at(sums, places[:, i], side * across)
    normals = sums[places] * side[:, None]
    return normals / np.maximum(np.linalg.norm(normals, axis=2, keepdims=True), 1e-300)


def add_attribute(mesh, name, kind, domain, values):
    attribute = mesh.attributes.new(name, kind, domain)
    attribute.data.foreach_set("vector" if kind == "FLOAT_VECTOR" else "value", np.ascontiguousarray(values).ravel())


def make_mesh(name, frame, time_of_second):
    """`time_of_second`: how much of the simulation's time (T) a second of the film shows."""
    mesh = bpy.data.meshes.new(name)
    count = len(frame.triangles)
    mesh.vertices.add(len(frame.positions))
    mesh.vertices.foreach_set("co", frame.positions.astype(np.float32).ravel())
    mesh.loops.add(3 * count)
    mesh.loops.foreach_set("vertex_index", frame.triangles.astype(np.int32).ravel())
    mesh.polygons.add(count)
    mesh.polygons.foreach_set("loop_start", np.arange(0, 3 * count, 3, dtype=np.int32))
    mesh.polygons.foreach_set("loop_total", np.full(count, 3, dtype=np.int32))
    mesh.polygons.foreach_set("use_smooth", np.ones(count, dtype=bool))
    mesh.update(calc_edges=True)
    if count:
        mesh.use_auto_smooth = True
        mesh.normals_split_custom_set(corner_normals(frame).reshape(-1, 3).tolist())
    if "velocity" in frame.point_values:
        velocity = (time_of_second * frame.point_values["velocity"]).astype(np.float32)
        add_attribute(mesh, "velocity", "FLOAT_VECTOR", "POINT", velocity)
    if "vertex_id" in frame.point_values:
        add_attribute(mesh, "vertex_id", "INT", "POINT", frame.point_values["vertex_id"].astype(np.int32))
    for key, values in frame.face_values.items():
        add_attribute(mesh, key, "INT", "FACE", values.astype(np.int32))
    return mesh


def show_only_in(thing, frame):
    for key in ("hide_viewport", "hide_render"):
        for when, hidden in ((frame - 1, True), (frame, False), (frame + 1, True)):
            setattr(thing, key, hidden)
            thing.keyframe_insert(key, frame=when)
    for curve in thing.animation_data.action.fcurves:
        for point in curve.keyframe_points:
            point.interpolation = "CONSTANT"


def film_material():
    """Reflects as water does, and lets the rest through as it is: a film has two faces, light leaves as it came."""
    material = bpy.data.materials.new("soap film")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    output, mix = nodes.new("ShaderNodeOutputMaterial"), nodes.new("ShaderNodeMixShader")
    fresnel, clear, glossy = (nodes.new(f"ShaderNode{kind}") for kind in ("Fresnel", "BsdfTransparent", "BsdfGlossy"))
    fresnel.inputs["IOR"].default_value = 1.5
    glossy.inputs["Roughness"].default_value = 0.0
    links.new(fresnel.outputs[0], mix.inputs[0])
    links.new(clear.outputs[0], mix.inputs[1])
    links.new(glossy.outputs[0], mix.inputs[2])
    links.new(mix.outputs[0], output.inputs["Surface"])
    return material


def add_sky(scene):
    """Bright above, dark below, with a band at the horizon: something for films to reflect."""
    world = scene.world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    place, split, ramp = (nodes.new(f"ShaderNode{kind}") for kind in ("TexCoord", "SeparateXYZ", "ValToRGB"))
    links.new(place.outputs["Generated"], split.inputs[0])
    links.new(split.outputs["Z"], ramp.inputs[0])
    links.new(ramp.outputs[0], nodes["Background"].inputs["Color"])
    colors = ramp.color_ramp.elements
    colors[0].position, colors[0].color = 0.0, (0.01, 0.012, 0.02, 1)
    colors[1].position, colors[1].color = 0.9, (0.6, 0.8, 1.4, 1)
    band = colors.new(0.12)
    band.color = (3.0, 2.6, 2.2, 1)
    colors.new(0.2).color = (0.05, 0.07, 0.12, 1)


def set_up_view(objects, size):
    """A camera that sees all of `objects`, a sky, and Cycles with motion blur; `size`: pixels."""
    scene = bpy.context.scene
    corners = np.array([corner for thing in objects for corner in thing.bound_box])
    middle = (corners.min(axis=0) + corners.max(axis=0)) / 2
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    scene.camera = camera
    turned = mathutils.Vector((0.35, -1.0, 0.3)).to_track_quat("Z", "Y")
    # So far away that every corner lies within the angles that the camera sees across and up.
    right, up, back = np.array(turned.to_matrix()).T
    half = np.tan(camera.data.angle / 2) * np.array(size) / max(size)
    places = corners - middle
    distance = max((abs(places @ axis) / tangent + places @ back).max() for axis, tangent in zip((right, up), half))
    camera.location = middle + 1.05 * distance * back
    camera.rotation_euler = turned.to_euler()
    add_sky(scene)
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.transparent_max_bounces = 128, 64
    scene.cycles.use_denoising = False  # not all builds of Blender have it
    scene.render.use_motion_blur = True
    scene.render.resolution_x, scene.render.resolution_y = size


def frames_of_run(folder):
    """Files, and the simulation's time between two (T)."""
    record = json.loads((folder / "run.json").read_text())
    files = sorted((folder / "frames").glob("frame_*.ply"))
    steps = [int(file.stem.split("_")[1]) for file in files]
    between = record["options"]["frame_every"] or max(steps) or 1
    # The last frame of a run may come sooner than the one after: film frames are equally long.
    files = [file for file, step in zip(files, steps) if step % between == 0]
    return files, record["dt"] * between


def import_foam(paths, frame_time=None, fps=24, every=1):
    """Makes the objects; returns them in the order of the film. See the top of this file."""
    paths = [pathlib.Path(path) for path in paths]
    if len(paths) == 1 and paths[0].is_dir():
        paths, frame_time = frames_of_run(paths[0])
    paths = paths[::every]
    if not paths:
        raise ValueError("no frames to import")
    scene = bpy.context.scene
    scene.render.fps, scene.render.fps_base = fps, 1
    scene.frame_start, scene.frame_end = 1, len(paths)
    collection = bpy.data.collections.new("foam")
    scene.collection.children.link(collection)
    material = film_material()
    objects = []
    for number, path in enumerate(paths, start=1):
        mesh = make_mesh(path.stem, read_frame(path), (frame_time or 0) * every * fps)
        mesh.materials.append(material)
        thing = bpy.data.objects.new(path.stem, mesh)
        collection.objects.link(thing)
        show_only_in(thing, number)
        objects.append(thing)
    return objects


def positive(text):
    if int(text) <= 0:
        raise argparse.ArgumentTypeError(f"{text} is not positive")
    return int(text)


def picture_size(text):
    width, height = text.split("x")
    return positive(width), positive(height)


def main(words):
    parser = argparse.ArgumentParser(prog="import_foam.py", description=__doc__.split("\n")[0])
    parser.add_argument("paths", nargs="+", help="the folder of a run, or .ply and .obj files")
    parser.add_argument("--frame-time", type=float, help="simulated time between two files (T); of a run it is known")
    parser.add_argument("--fps", type=positive, default=24, help="frames a second of the film")
    parser.add_argument("--every", type=positive, default=1, help="take one frame of so many")
    parser.add_argument("--view", metavar="WxH", type=picture_size, help="a new scene with camera and sky, and Cycles set up for pictures of this size")
    parser.add_argument("--save", metavar="FILE", help="write a .blend file")
    arguments = parser.parse_args(words)
    if arguments.view:
        bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    objects = import_foam(arguments.paths, arguments.frame_time, arguments.fps, arguments.every)
    bpy.context.scene.frame_set(1)
    if arguments.view:
        set_up_view(objects, arguments.view)
    if arguments.save:
        bpy.ops.wm.save_as_mainfile(filepath=str(pathlib.Path(arguments.save).absolute()))
    print(f"{len(objects)} frames imported")


if __name__ == "__main__":
    try:
        main(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else [])
    except (ValueError, OSError, KeyError) as error:
        sys.exit(f"import_foam.py: {error}")
