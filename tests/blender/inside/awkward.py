"""What artists do to an engine: switched off and on, no camera, nothing to see, much to see, cancelled."""

import os
import pathlib
import sys
import time

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import common


def fails(says):
    """A render that cannot be made says why."""
    try:
        common.render("fails")
    except RuntimeError as error:
        common.check(says in str(error), f"'{says}' is not in: {error}")
    else:
        common.check(False, f"no error that says '{says}'")


def engine():
    """The class of ours; None where it is not registered. Some of Blender's own have no name."""
    return next((kind for kind in bpy.types.RenderEngine.__subclasses__()
                 if kind.is_registered and getattr(kind, "bl_idname", None) == "OPALINE"), None)


common.install()
for _ in range(2):
    bpy.ops.preferences.addon_disable(module="opaline_blender")
    common.check(engine() is None, "the engine is still there")
    bpy.ops.preferences.addon_enable(module="opaline_blender")

scene = common.empty_scene(32)
fails("camera")
common.camera((0.05, -0.2, 0.08))
scene.world.color = (0.25, 0.5, 0.75)
nothing = common.render("nothing")
common.check(np.allclose(nothing, (0.25, 0.5, 0.75, 1), atol=1e-3), "an empty scene is not its world's colour")

# Two hundred objects, of which half are instances of a collection; a mirrored one, one without faces, one of no size.
jade, matt = common.material("Jade", "jade"), common.material("Matt", color=(0.7, 0.2, 0.1))
shared = bpy.data.collections.new("Shared")
original = common.cube("Shared cube", 0.002, matt)
bpy.context.collection.objects.unlink(original)
shared.objects.link(original)
for i in range(100):
    place = (0.01 * (i % 10) - 0.045, 0.01 * (i // 10) - 0.045, 0)
    body = common.cube(f"Body {i}", 0.003, jade if i % 2 else matt)
    body.location = place
    body.scale = (-1, 1, 1) if i == 7 else (0, 0, 0) if i == 8 else (1, 1, 1)
    instance = common.add(f"Instance {i}", None, (place[0], place[1], 0.012))
    instance.instance_type, instance.instance_collection = "COLLECTION", shared
common.add("Points", bpy.data.meshes.new("Points")).data.from_pydata([(0, 0, 0)], [], [])
common.lamp("AREA", (0.1, -0.1, 0.2), 1.0, size=0.1)
many = common.render("many")
common.check(np.isfinite(many).all() and many[..., :3].std() > 0.01, "two hundred objects are not shown")

# What is hidden is not rendered, and comes back.
for thing in bpy.data.objects:
    thing.hide_render = thing.type in ("MESH", "EMPTY")
hidden = common.render("hidden")
common.check(np.allclose(hidden[..., :3], (0.25, 0.5, 0.75), atol=1e-3), "hidden objects are shown")
for thing in bpy.data.objects:
    thing.hide_render = thing.type == "EMPTY"

# Passes, and a part of the picture.
layer = bpy.context.view_layer
layer.use_pass_z = layer.use_pass_normal = layer.opaline.use_pass_exitance = True
scene.render.film_transparent = True
scene.use_nodes = True
nodes = scene.node_tree.nodes
files = nodes.new("CompositorNodeOutputFile")
files.base_path = str(common.FOLDER)
files.format.file_format, files.format.color_depth = "OPEN_EXR", "32"
for name in ("Depth", "Normal", "Exitance"):
    files.file_slots.new(name)
    scene.node_tree.links.new(nodes["Render Layers"].outputs[name], files.inputs[name])
combined = common.render("passes")
scene.use_nodes = False
depth, normal, exitance = (common.picture(next(common.FOLDER.glob(f"{name}*.exr"))) for name in ("Depth", "Normal", "Exitance"))
covered = combined[..., 3] > 0.9
common.check(covered.any() and not covered.all(), "nothing is covered, or all is")
# In Blender's units: the camera is 0.22 from the middle.
common.check(0.1 < depth[covered][:, 0].min() and depth[covered][:, 0].max() < 0.35, "depths are wrong")
common.check(depth[~covered][:, 0].max() > 1e9, "what covers nothing is not far away")
lengths = np.linalg.norm(normal[covered][:, :3], axis=1)
common.check(np.allclose(lengths, 1, atol=0.02), "normals are not unit vectors")
common.check((normal[covered][:, 2] > 0.9).mean() > 0.3, "what lies flat does not point up")
common.check(exitance[covered][:, :3].max() > 0.01, "there is no exitance")
layer.use_pass_z = layer.use_pass_normal = layer.opaline.use_pass_exitance = False
whole = common.render("whole")
scene.render.use_border = scene.render.use_crop_to_border = True
scene.render.border_min_x, scene.render.border_max_x = 0.25, 0.75
scene.render.border_min_y, scene.render.border_max_y = 0.5, 1.0
part = common.render("part")
common.check(part.shape[:2] == (16, 16), f"a part has the size {part.shape}")
same = np.abs(part - whole[:16, 8:24])[..., :3].mean() / whole[:16, 8:24, :3].mean()
common.check(same < 0.02, f"a part differs from the whole by {same}")
scene.render.use_border = False

# Clip distances would cut everything off.
scene.camera.data.clip_start, scene.camera.data.clip_end = 10, 20
common.check(np.abs(common.render("clipped") - whole).max() < 1e-4, "clip distances change the picture")

# Cancelled by the engine's own question whether it is: what was begun is left.
ours = engine()
ours.test_break = lambda self: True
scene.render.resolution_x = scene.render.resolution_y = 64
common.render("cancelled")
del ours.test_break
time.sleep(0.5)
scene.render.resolution_x = scene.render.resolution_y = 32
common.check(np.abs(common.render("after") - whole).max() < 1e-4, "after a cancelled render the picture is another")

# Another version is installed over the one that is in use.
bpy.ops.preferences.addon_install(filepath=os.environ["OPALINE_ADDON"], overwrite=True)
bpy.ops.preferences.addon_enable(module="opaline_blender")
common.empty_scene(32)
common.camera((0.05, -0.2, 0.08))
common.check(np.isfinite(common.render("after")).all(), "nothing is rendered after an update")
