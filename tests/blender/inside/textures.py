"""Pictures on the inputs of a Principled BSDF look as in Cycles."""

import pathlib
import sys

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import common

common.install()


def stage(**inputs):
    """A square metre with coordinates, seen from above; its material's tree and shader."""
    scene = common.empty_scene(32)
    scene.opaline.samples = "8"
    made = common.material("Textured", roughness=1.0, specular=0.0)
    floor = common.plane(half=0.5, made=made)
    places = floor.data.uv_layers.new(name="UVMap").data
    for corner, place in zip(places, ((0, 0), (1, 0), (1, 1), (0, 1))):
        corner.uv = place
    common.camera((0, 0, 1.6), 72)
    common.lamp("SUN", (0.2, 0.1, 1), 3)
    shader = made.node_tree.nodes["Principled BSDF"]
    for name, value in inputs.items():
        common.shader_input(shader, name.replace("_", " ")).default_value = value
    return made.node_tree, shader


def image(name, pixels, is_color=False):
    """Of rows from the top, each of (red, green, blue) or (red, green, blue, alpha)."""
    pixels = np.array(pixels, dtype=np.float32)
    if pixels.shape[2] == 3:
        pixels = np.concatenate([pixels, np.ones((*pixels.shape[:2], 1), dtype=np.float32)], axis=2)
    made = bpy.data.images.new(name, pixels.shape[1], pixels.shape[0], alpha=True)
    made.colorspace_settings.name = "sRGB" if is_color else "Non-Color"
    made.alpha_mode = "CHANNEL_PACKED"
    made.pixels.foreach_set(np.ascontiguousarray(pixels[::-1]).ravel())
    made.pack()
    return made


def texture(tree, picture):
    node = tree.nodes.new("ShaderNodeTexImage")
    node.image = picture
    node.interpolation = "Closest"
    return node


def colors():
    tree, shader = stage()
    node = texture(tree, image("Colors", [[(0.9, 0.1, 0.1), (0.1, 0.9, 0.1)], [(0.1, 0.1, 0.9), (0.5, 0.5, 0.5)]], is_color=True))
    tree.links.new(node.outputs["Color"], shader.inputs["Base Color"])
    common.compare_with_cycles("colors")
    # Turned, moved and repeated.
    where, turn = tree.nodes.new("ShaderNodeTexCoord"), tree.nodes.new("ShaderNodeMapping")
    turn.inputs["Location"].default_value = (0.25, 0.1, 0)
    turn.inputs["Rotation"].default_value = (0, 0, 0.5)
    turn.inputs["Scale"].default_value = (1.5, 1, 1)
    tree.links.new(where.outputs["UV"], turn.inputs["Vector"])
    tree.links.new(turn.outputs["Vector"], node.inputs["Vector"])
    common.compare_with_cycles("colors by a mapping")


def glow():
    tree, shader = stage(Base_Color=(0, 0, 0, 1), Emission_Strength=2.0)
    node = texture(tree, image("Glow", [[(0.9, 0.4, 0.1), (0, 0, 0)], [(0.1, 0.5, 0.9), (0.3, 0.3, 0.3)]], is_color=True))
    tree.links.new(node.outputs["Color"], common.shader_input(shader, "Emission"))
    common.compare_with_cycles("emission")


def holes():
    tree, shader = stage()
    node = texture(tree, image("Holes", [[(0.8, 0.6, 0.4, 1), (0.8, 0.6, 0.4, 0)], [(0.8, 0.6, 0.4, 0), (0.4, 0.6, 0.8, 1)]], is_color=True))
    tree.links.new(node.outputs["Color"], shader.inputs["Base Color"])
    # Alpha that the shader does not use is not alpha.
    common.compare_with_cycles("no holes")
    tree.links.new(node.outputs["Alpha"], shader.inputs["Alpha"])
    common.compare_with_cycles("holes")
    # The same mask by a mixture with Transparent.
    tree.links.remove(shader.inputs["Alpha"].links[0])
    clear, mixed = tree.nodes.new("ShaderNodeBsdfTransparent"), tree.nodes.new("ShaderNodeMixShader")
    tree.links.new(clear.outputs["BSDF"], mixed.inputs[1])
    tree.links.new(shader.outputs["BSDF"], mixed.inputs[2])
    tree.links.new(node.outputs["Alpha"], mixed.inputs["Fac"])
    tree.links.new(mixed.outputs["Shader"], tree.nodes["Material Output"].inputs["Surface"])
    common.compare_with_cycles("holes by a mixture")


def polish():
    """Where facets send little on to each other, which the Principled BSDF of 3.x leaves out unless it is asked."""
    tree, shader = stage(Base_Color=(0.8, 0.7, 0.5, 1), Metallic=1.0)
    node = texture(tree, image("Roughness", [[(0.2,) * 3, (0.35,) * 3], [(0.3,) * 3, (0.25,) * 3]]))
    tree.links.new(node.outputs["Color"], shader.inputs["Roughness"])
    common.compare_with_cycles("roughness")
    # As a colour the same number is a darker one: 0.6 is 0.319.
    node.image = image("Roughness of a colour", [[(0.6,) * 3]], is_color=True)
    common.compare_with_cycles("roughness of a colour")

    # Roughness is green; metallic is blue, then red.
    tree, shader = stage(Base_Color=(0.8, 0.7, 0.5, 1), Specular=0.5)
    packed = texture(tree, image("Packed", [[(1, 0.2, 1), (0, 0.35, 0)], [(1, 0.3, 0), (0, 0.25, 1)]]))
    split = tree.nodes.new("ShaderNodeSeparateColor")
    tree.links.new(packed.outputs["Color"], split.inputs["Color"])
    tree.links.new(split.outputs["Green"], shader.inputs["Roughness"])
    tree.links.new(split.outputs["Blue"], shader.inputs["Metallic"])
    common.compare_with_cycles("a packed picture")
    tree.links.new(split.outputs["Red"], shader.inputs["Metallic"])
    common.compare_with_cycles("another channel")


def tilt():
    """A normal map that leans to the right and to the back."""
    tree, shader = stage()
    node = texture(tree, image("Normals", [[(0.5, 0.5, 1), (0.8, 0.5, 0.9)], [(0.5, 0.8, 0.9), (0.35, 0.35, 0.95)]]))
    mapped = tree.nodes.new("ShaderNodeNormalMap")
    tree.links.new(node.outputs["Color"], mapped.inputs["Color"])
    tree.links.new(mapped.outputs["Normal"], shader.inputs["Normal"])
    common.compare_with_cycles("normals")


def repaint():
    """Pictures that change between two renders."""
    tree, shader = stage()
    picture = image("Painted", [[(0.9, 0.1, 0.1), (0.1, 0.9, 0.1)]], is_color=True)
    node = texture(tree, picture)
    tree.links.new(node.outputs["Color"], shader.inputs["Base Color"])
    common.compare_with_cycles("before painting")
    picture.pixels.foreach_set(np.array((0.1, 0.1, 0.9, 1, 0.8, 0.8, 0.2, 1), dtype=np.float32))
    picture.update()
    common.compare_with_cycles("painted")
    picture.pixels.foreach_set(np.array((0.5, 0.2, 0.7, 1, 0.1, 0.6, 0.2, 1), dtype=np.float32))
    picture.pack()
    common.compare_with_cycles("packed")


for test in (colors, glow, holes, polish, tilt, repaint):
    test()
