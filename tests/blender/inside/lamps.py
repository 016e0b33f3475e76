"""Lamps of every kind, the world, and materials that let no light in are as bright as in Cycles."""

import math
import pathlib
import sys

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import common

SAMPLES = 64
common.install()


def both(name, edge=16):
    """Means of a picture's parts, four by four, by both engines."""
    scene = bpy.context.scene
    means = []
    for engine in ("OPALINE", "CYCLES"):
        scene.render.engine = engine
        if engine == "CYCLES":
            scene.cycles.samples = SAMPLES
            scene.cycles.use_adaptive_sampling = scene.cycles.use_denoising = False
            scene.cycles.max_bounces = 0
        shown = common.render(f"{name}_{engine.lower()}")[..., :3]
        means.append(shown.reshape(4, edge // 4, 4, edge // 4, 3).mean(axis=(1, 3)))
    return means


def compare(name, most=0.03):
    ours, cycles = both(name)
    error = np.sqrt(((ours - cycles) ** 2).mean()) / cycles.mean()
    print(f"{name}: {ours.mean():.5f} and {cycles.mean():.5f}, blocks within {100 * error:.1f} %")
    common.check(error < most, f"{name} differs by {100 * error:.1f} %")


def stage():
    """A matt floor of a metre, seen from above."""
    common.empty_scene(16)
    matt = common.material("Floor")
    nodes = matt.node_tree.nodes
    nodes.remove(nodes["Principled BSDF"])
    shader = nodes.new("ShaderNodeBsdfDiffuse")
    shader.inputs["Color"].default_value = (0.8, 0.5, 0.3, 1)
    matt.node_tree.links.new(shader.outputs["BSDF"], nodes["Material Output"].inputs["Surface"])
    common.plane(half=0.5, made=matt)
    common.camera((0, 0, 1.0), 72)


LAMPS = {
    "sun": ("SUN", (0.5, 0.3, 1), 3.0, {}),
    "point": ("POINT", (0.1, 0.05, 0.3), 2.0, {"shadow_soft_size": 0}),
    "ball": ("POINT", (0.1, 0.05, 0.3), 2.0, {"shadow_soft_size": 0.02}),
    "spot": ("SPOT", (0.3, 0, 1.2), 40.0, {"shadow_soft_size": 0, "spot_size": math.radians(24), "spot_blend": 0.3}),
    "square": ("AREA", (0.2, 0.1, 0.3), 3.0, {"shape": "SQUARE", "size": 0.2}),
    "rectangle": ("AREA", (0.2, 0.1, 0.3), 3.0, {"shape": "RECTANGLE", "size": 0.3, "size_y": 0.1}),
    "disk": ("AREA", (0.2, 0.1, 0.3), 3.0, {"shape": "DISK", "size": 0.2}),
}
for lamp, (kind, place, energy, settings) in LAMPS.items():
    stage()
    common.lamp(kind, place, energy, **settings)
    compare(lamp)

stage()
bpy.context.scene.world.color = (0.3, 0.5, 0.7)
compare("world")

# A sky that is bright on one side.
stage()
bpy.data.objects["Plane"].rotation_euler = (0.7, 0.4, 0)
sky = bpy.data.images.new("Sky", 64, 32, float_buffer=True)
pixels = np.full((32, 64, 4), 0.1, dtype=np.float32)
pixels[16:28, 4:14, :3] = (3, 2, 1)
sky.pixels.foreach_set(pixels.ravel())
world = bpy.context.scene.world
world.use_nodes = True
picture = world.node_tree.nodes.new("ShaderNodeTexEnvironment")
picture.image = sky
world.node_tree.links.new(picture.outputs["Color"], world.node_tree.nodes["Background"].inputs["Color"])
compare("sky", 0.05)
turn = world.node_tree.nodes.new("ShaderNodeMapping")
where = world.node_tree.nodes.new("ShaderNodeTexCoord")
turn.inputs["Rotation"].default_value[2] = 1.0
world.node_tree.links.new(where.outputs["Generated"], turn.inputs["Vector"])
world.node_tree.links.new(turn.outputs["Vector"], picture.inputs["Vector"])
compare("turned sky", 0.05)
