"""Three frames of a subdivided body that moves and changes its shape, under an area lamp; and what glTF has of the second."""

import math
import pathlib
import sys

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import common

common.install()
scene = common.empty_scene(96)
body = common.cube(half=0.02, made=common.material("Body", "marble"), levels=4)
body.rotation_euler = (0.3, 0.2, 0.5)
twist = body.modifiers.new("Twist", "SIMPLE_DEFORM")
twist.deform_method = "TWIST"
for frame, place, angle in ((1, -0.01, 0.0), (3, 0.01, 0.8)):
    body.location.x = place
    twist.angle = angle
    body.keyframe_insert("location", frame=frame)
    twist.keyframe_insert("angle", frame=frame)
common.camera((0.03, -0.13, 0.02))
scene.render.film_transparent = True
# Its middle, half edges and radiance of 40 are given to `opaline render` by the test.
common.lamp("AREA", (0, 0, 0.1), 0.1 * (math.pi if bpy.app.version >= (4, 0, 0) else 4), shape="SQUARE", size=0.05)
scene.frame_start, scene.frame_end = 1, 3
scene.render.filepath = str(common.FOLDER / "frame")
bpy.ops.render.render(animation=True)
pictures = [common.picture(common.FOLDER / f"frame{frame:04}.exr") for frame in (1, 2, 3)]
for shown in pictures:
    common.check(np.isfinite(shown).all(), "a picture is not finite")
    common.check(0.05 < (shown[..., 3] > 0).mean() < 0.9, "a picture shows nothing, or no background")
    common.check(shown[..., :3].max() > 0.02, "a picture is dark")
moved = [np.abs(a - b)[..., :3].mean() for a, b in zip(pictures, pictures[1:])]
common.check(min(moved) > 1e-3, f"nothing moves: {moved}")
scene.frame_set(2)
bpy.ops.export_scene.gltf(filepath=str(common.FOLDER / "frame2.glb"), export_apply=True, export_animations=False, export_cameras=True,
                          export_current_frame=True)
