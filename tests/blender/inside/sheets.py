"""Sheets of Translucent, alone and mixed, seen from the side of the sun and from the other: as in Cycles, and as the equations say."""

import math
import pathlib
import sys

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import common

EDGE, SUN = 48, 3.0


def sheet(name, node_type, front, through, factor=None, first="front"):
    """Of one mixture; of Translucent alone where there is no node."""
    made = common.matt(name, front)
    tree = made.node_tree
    surface = tree.nodes["Material Output"].inputs["Surface"]
    diffuse = tree.nodes["Diffuse BSDF"].outputs["BSDF"]
    node = tree.nodes.new("ShaderNodeBsdfTranslucent")
    node.inputs["Color"].default_value = (*through, 1)
    translucent = node.outputs["BSDF"]
    if node_type is None:
        tree.links.new(translucent, surface)
        return made
    mixed = tree.nodes.new(node_type)
    inputs = [entry for entry in mixed.inputs if entry.type == "SHADER"]
    for entry, output in zip(inputs, (diffuse, translucent) if first == "front" else (translucent, diffuse)):
        tree.links.new(output, entry)
    if factor is not None:
        mixed.inputs["Fac"].default_value = factor
    tree.links.new(mixed.outputs["Shader"], surface)
    return made


common.install()
scene = common.empty_scene(EDGE)
common.lamp("SUN", (0.2, 0.1, 1), SUN, angle=0)
SHEETS = (  # and the share of the light that each gives back, and lets through
    (sheet("Mixed", "ShaderNodeMixShader", (0.8, 0.4, 0.2), (0.3, 0.7, 0.5), 0.3), (0.56, 0.28, 0.14), (0.09, 0.21, 0.15)),
    (sheet("Other way round", "ShaderNodeMixShader", (0.8, 0.4, 0.2), (0.3, 0.7, 0.5), 0.8, "through"),
     (0.64, 0.32, 0.16), (0.06, 0.14, 0.1)),
    (sheet("Sum", "ShaderNodeAddShader", (0.4, 0.2, 0.1), (0.1, 0.3, 0.4)), (0.4, 0.2, 0.1), (0.1, 0.3, 0.4)),
    (sheet("Alone", None, (0, 0, 0), (0.2, 0.6, 0.4)), (0, 0, 0), (0.2, 0.6, 0.4)),
)
PLACES = (-0.075, -0.075), (0.075, -0.075), (-0.075, 0.075), (0.075, 0.075)
for (made, _, _), (x, y) in zip(SHEETS, PLACES):
    common.plane(made.name, 0.075, made, (x, y, 0))
view = common.camera((0, 0, 0.3), 36)
radiance = SUN / math.sqrt(0.2 ** 2 + 0.1 ** 2 + 1) / math.pi  # of what gives back all light
for side, (height, turn) in enumerate(((0.3, 0), (-0.3, math.pi))):
    view.location.z, view.rotation_euler = height, (turn, 0, 0)
    common.compare_with_cycles(f"sheets from side {side}", most=0.01, parts=8)
    shown = common.render(f"side_{side}")[..., :3]
    for sheet_shares, (x, y) in zip(SHEETS, PLACES):
        row, column = round((0.5 - (y if side == 0 else -y) / 0.3) * EDGE), round((0.5 + x / 0.3) * EDGE)
        wanted = radiance * np.array(sheet_shares[1 + side])
        common.check(np.allclose(shown[row, column], wanted, atol=0.003 * radiance),
                     f"{sheet_shares[0].name}, side {side}: {shown[row, column]} instead of {wanted}")

# A renderer that follows shows what one that begins anew does.
SHEETS[0][0].node_tree.nodes["Mix Shader"].inputs["Fac"].default_value = 0.0
closed = common.render("followed")
SHEETS[0][0].node_tree.nodes["Mix Shader"].inputs["Fac"].default_value = 0.6
followed = common.render("followed")
from opaline_blender import final
final.forget()
common.check(np.array_equal(followed, common.render("anew")), "a sheet that was followed looks otherwise than anew")
common.check(np.abs(followed - closed).max() > 0.1, "what lets light through looks as what does not")
