"""For scripts that run inside of Blender: the add-on from its zip, and small scenes."""

import os
import pathlib
import sys

import bpy
import numpy as np
from mathutils import Vector

ARGUMENTS = sys.argv[sys.argv.index("--") + 1:]
FOLDER = pathlib.Path(ARGUMENTS[0])


def install(max_surfels=8192, max_clusters=1024):
    """The add-on, with divisions as coarse as small pictures may have them."""
    bpy.ops.preferences.addon_install(filepath=os.environ["OPALINE_ADDON"])
    bpy.ops.preferences.addon_enable(module="opaline_blender")
    from opaline_blender import final, live

    # Stills share their renderer, as frames of an animation do, whose shaders then are compiled once.
    bpy.app.handlers.render_complete.remove(final.forget)
    of_all = live.LiveRenderer.render
    live.LiveRenderer.render = lambda *words, **options: of_all(*words, max_surfels=max_surfels, max_clusters=max_clusters, **options)
    return use()


def use():
    bpy.context.scene.render.engine = "OPALINE"
    return bpy.context.scene


def empty_scene(edge=64):
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    scene = use()
    scene.opaline.samples, scene.opaline.bounces = "1", 2
    scene.render.resolution_x = scene.render.resolution_y = edge
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.world = bpy.data.worlds.new("World")
    scene.world.color = (0, 0, 0)
    return scene


def add(name, data, place=(0, 0, 0)):
    thing = bpy.data.objects.new(name, data)
    thing.location = place
    bpy.context.collection.objects.link(thing)
    return thing


def aim(thing, target=(0, 0, 0)):
    thing.rotation_euler = (Vector(target) - thing.location).to_track_quat("-Z", "Y").to_euler()
    return thing


def camera(place=(0, -0.3, 0), lens=50):
    view = add("Camera", bpy.data.cameras.new("Camera"), place)
    view.data.lens = lens
    bpy.context.scene.camera = aim(view)
    return view


def lamp(kind, place=(0, 0, 1), energy=1, **settings):
    data = bpy.data.lights.new(kind.title(), kind)
    data.energy = energy
    for name, value in settings.items():
        setattr(data, name, value)
    return aim(add(kind.title(), data, place))


NEWER_NAMES = {"Subsurface": "Subsurface Weight", "Specular": "Specular IOR Level", "Emission": "Emission Color"}  # of 4.x


def shader_input(shader, name):
    """Of a Principled BSDF, by its name in 3.x."""
    return shader.inputs[name if name in shader.inputs else NEWER_NAMES[name]]


def material(name, medium=None, color=(0.8, 0.8, 0.8), **inputs):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*color, 1)
    for key, value in inputs.items():
        shader_input(shader, key.replace("_", " ").title().replace("Ior", "IOR")).default_value = value
    if medium:
        made.opaline.medium_item = medium
    return made


def matt(name, color):
    """Lambert's surface: the diffuse part of a Principled BSDF of 3.x is that of Burley 2012."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes = made.node_tree.nodes
    nodes.remove(nodes["Principled BSDF"])
    shader = nodes.new("ShaderNodeBsdfDiffuse")
    shader.inputs["Color"].default_value = (*color, 1)
    made.node_tree.links.new(shader.outputs["BSDF"], nodes["Material Output"].inputs["Surface"])
    return made


def cube(name="Cube", half=0.02, made=None, levels=0):
    mesh = bpy.data.meshes.new(name)
    corners = [(x, y, z) for x in (-half, half) for y in (-half, half) for z in (-half, half)]
    mesh.from_pydata(corners, [], [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])
    thing = add(name, mesh)
    if made is not None:
        mesh.materials.append(made)
    if levels:
        mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
        modifier = thing.modifiers.new("Subdivision", "SUBSURF")
        modifier.levels = modifier.render_levels = levels
    return thing


def column(name, half, made, levels):
    """Twice as high as wide."""
    body = cube(name, half, made, levels)
    for vertex in body.data.vertices:
        vertex.co.z *= 2
    return body


def rig_of(body, half_height):
    """An armature that holds the lower half of a body still and moves the upper one with the bone "Tip"."""
    bpy.ops.object.armature_add(location=(0, 0, -half_height))
    rig = bpy.context.object
    bpy.ops.object.mode_set(mode="EDIT")
    root = rig.data.edit_bones[0]
    root.name, root.tail = "Root", (0, 0, half_height)
    tip = rig.data.edit_bones.new("Tip")
    tip.head, tip.tail, tip.parent = root.tail, (0, 0, 2 * half_height), root
    bpy.ops.object.mode_set(mode="OBJECT")
    for name, low in (("Root", True), ("Tip", False)):
        body.vertex_groups.new(name=name).add([v.index for v in body.data.vertices if (v.co.z < 0) == low], 1, "REPLACE")
    body.modifiers.new("Armature", "ARMATURE").object = rig
    body.parent = rig
    body.matrix_parent_inverse = rig.matrix_world.inverted()
    rig.pose.bones["Tip"].rotation_mode = "XYZ"
    return rig


def plane(name="Plane", half=1.0, made=None, place=(0, 0, 0)):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)], [], [(0, 1, 2, 3)])
    if made is not None:
        mesh.materials.append(made)
    return add(name, mesh, place)


def render(name="still", frame=None):
    """The picture, linear: array (height, width, 4), row 0 at the top."""
    scene = bpy.context.scene
    if frame is not None:
        scene.frame_set(frame)
    scene.render.filepath = str(FOLDER / f"{name}.exr")
    bpy.ops.render.render(write_still=True)
    return picture(FOLDER / f"{name}.exr")


def picture(file):
    image = bpy.data.images.load(str(file))
    image.colorspace_settings.name = "Non-Color"
    width, height = image.size
    values = np.empty(width * height * image.channels, dtype=np.float32)
    image.pixels.foreach_get(values)
    bpy.data.images.remove(image)
    return values.reshape(height, width, -1)[::-1]


def both_engines(name, samples=64, bounces=0):
    """Pictures of Opaline and of Cycles."""
    scene = bpy.context.scene
    scene.opaline.bounces = 0
    pictures = []
    for engine in ("OPALINE", "CYCLES"):
        scene.render.engine = engine
        if engine == "CYCLES":
            scene.cycles.samples = samples
            scene.cycles.use_adaptive_sampling = scene.cycles.use_denoising = False
            scene.cycles.max_bounces = bounces
            scene.cycles.pixel_filter_type = "BOX"  # so that blocks share nothing
        pictures.append(render(f"{name}_{engine.lower()}")[..., :3])
    scene.render.engine = "OPALINE"
    return pictures


def compare_with_cycles(name, most=0.03, parts=4, samples=64):
    """Means of so many parts of the picture's width and height."""
    ours, cycles = ([strip.mean(axis=(0, 1)) for row in np.split(shown, parts) for strip in np.split(row, parts, axis=1)]
                    for shown in both_engines(name, samples))
    ours, cycles = np.array(ours), np.array(cycles)
    error = np.sqrt(((ours - cycles) ** 2).mean()) / cycles.mean()
    print(f"{name}: {ours.mean():.5f} and {cycles.mean():.5f}, blocks within {100 * error:.1f} %")
    check(error < most, f"{name} differs by {100 * error:.1f} %")


def check(holds, what):
    if not holds:
        print(f"WRONG: {what}")
        sys.stdout.flush()
        os._exit(3)
