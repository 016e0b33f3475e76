"""The world: a colour, or an environment picture."""

import dataclasses
import math

import numpy as np

from . import images, nodes


@dataclasses.dataclass(frozen=True)
class World:
    ambient: tuple = (0.0, 0.0, 0.0)  # radiance
    image: object = None  # bpy.types.Image, latitude by longitude
    strength: float = 1.0
    turn_degrees: float = 0.0  # about the vertical, counter-clockwise seen from above
    state: tuple = ()  # of the picture's pixels

    def key(self):
        return (self.image.name_full, self.strength, self.turn_degrees, self.state) if self.image else None

    def picture(self):
        """Radiance as an environment of ours: the top is up, and the middle looks along Blender's y."""
        pixels = images.radiance_of(self.image)
        if pixels is None:
            return None
        # Blender's middle looks along x, a quarter further to the right.
        return np.roll(np.maximum(np.nan_to_num(pixels[..., :3]), 0), pixels.shape[1] // 4, axis=1)


DARK = World()


def world_of(world, notes):
    """The environment of a bpy.types.World, or of None."""
    if world is None:
        return DARK
    if not world.use_nodes or world.node_tree is None:
        return World(ambient=tuple(world.color))
    output = world.node_tree.get_output_node("CYCLES") or world.node_tree.get_output_node("ALL")
    behind = nodes.source(output.inputs["Surface"]) if output is not None else None
    if behind is None:
        return DARK
    node = behind.node
    if node.type not in ("BACKGROUND", "EMISSION"):
        notes.add("worlds whose shader is no background are not shown", world.name)
        return DARK
    strength = nodes.number(node, 1, "Strength")
    color = nodes.socket(node, "Color")
    behind = nodes.source(color)
    if behind is None or behind.node.type == "RGB":
        return World(ambient=tuple(strength * np.array(nodes.vector(node, (0, 0, 0), "Color"))))
    if behind.node.type != "TEX_ENVIRONMENT" or behind.node.image is None or behind.node.projection != "EQUIRECTANGULAR":
        notes.add("nodes of worlds but colours and equirectangular pictures are not shown", world.name)
        return World(ambient=tuple(strength * np.array(tuple(color.default_value)[:3])))
    return World(image=behind.node.image, strength=strength, turn_degrees=_turn(behind.node, notes, world.name),
                 state=images.state_of(behind.node.image))


def _turn(node, notes, name):
    behind = nodes.source(nodes.socket(node, "Vector"))
    if behind is None or behind.node.type == "TEX_COORD":
        return 0.0
    if behind.node.type != "MAPPING":
        notes.add("nodes before the world's picture are not shown", name)
        return 0.0
    x, y, z = behind.node.inputs["Rotation"].default_value
    if abs(x) + abs(y) > 1e-4:
        notes.add("the world's picture is turned about the vertical alone", name)
    return -math.degrees(z)
