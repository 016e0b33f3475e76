"""Lamps of every kind, the world, and materials that let no light in are as bright as in Cycles."""

import math
import pathlib
import sys

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import common

common.install()


def stage():
    """A matt floor of a metre, seen from above."""
    common.empty_scene(16)
    common.plane(half=0.5, made=common.matt("Floor", (0.8, 0.5, 0.3)))
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
    common.compare_with_cycles(lamp)

stage()
bpy.context.scene.world.color = (0.3, 0.5, 0.7)
common.compare_with_cycles("world")

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
common.compare_with_cycles("sky", 0.05)
turn = world.node_tree.nodes.new("ShaderNodeMapping")
where = world.node_tree.nodes.new("ShaderNodeTexCoord")
turn.inputs["Rotation"].default_value[2] = 1.0
world.node_tree.links.new(where.outputs["Generated"], turn.inputs["Vector"])
world.node_tree.links.new(turn.outputs["Vector"], picture.inputs["Vector"])
common.compare_with_cycles("turned sky", 0.05)
