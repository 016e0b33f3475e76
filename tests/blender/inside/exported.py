"""Bodies that an armature and a shape key move: what the engine shows of one moment, and what Blender's exporter writes of all."""

import pathlib
import sys

import bpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import common

FRAME = 9
# Of all that moves, not one of each object.
ONE_CLIP = {"export_animation_mode": "ACTIVE_ACTIONS"} if bpy.app.version >= (4, 0, 0) else {"export_nla_strips": False}


def shaded_smooth(body):
    body.data.polygons.foreach_set("use_smooth", [True] * len(body.data.polygons))


def keyed(data, path, values):
    for frame, value in values:
        setattr(data, path, value)
        data.keyframe_insert(path, frame=frame)


def bent(made):
    """A rounded column that a bone bends."""
    body = common.column("Column", 0.015, made, levels=3)
    bpy.context.view_layer.objects.active = body
    bpy.ops.object.modifier_apply(modifier="Subdivision")
    rig = common.rig_of(body, 0.03)
    keyed(rig.pose.bones["Tip"], "rotation_euler", ((1, (0, 0, 0)), (17, (0.9, 0, 0.3))))
    rig.location.x = -0.025


def drawn(made):
    """Half of a ball that a key draws out."""
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=4, radius=0.018)
    body = bpy.context.object
    body.location = (0.025, 0, 0)
    body.data.materials.append(made)
    shaded_smooth(body)
    body.shape_key_add(name="Basis")
    key = body.shape_key_add(name="Drawn")
    for point in key.data:
        if point.co.z > 0:
            point.co.z *= 2.2
            point.co.x += 0.6 * point.co.z
    keyed(key, "value", ((1, 0.0), (17, 1.0)))


def moving():
    scene = common.empty_scene(96)
    scene.render.fps = 24
    scene.frame_start, scene.frame_end = 1, 17
    scene.render.film_transparent = True
    made = common.material("Body", "marble", roughness=0.5)
    bent(made)
    drawn(made)
    common.camera((0.03, -0.2, 0.04))
    common.lamp("SUN", (0.3, -0.5, 1), 3, angle=0)
    common.render("moment", FRAME)
    bpy.ops.export_scene.gltf(filepath=str(common.FOLDER / "moving.glb"), export_apply=False, export_cameras=True,
                              export_frame_range=True, **ONE_CLIP)


def subsurface():
    """Suzanne with subsurface of which the exporter writes nothing, and with the property of which it does."""
    common.empty_scene()
    bpy.ops.mesh.primitive_monkey_add(size=0.05)
    body = bpy.context.object
    shaded_smooth(body)
    body.modifiers.new("Subdivision", "SUBSURF").levels = 2
    made = common.material("Wax of an artist", color=(0.8, 0.5, 0.3), subsurface=1.0)
    body.data.materials.append(made)
    for name, length in (("plain", None), ("told", (2.0, 1.0, 0.5))):
        if length:
            made["mean_free_path_mm"] = length
            made.update_tag()  # else an exporter that applies modifiers may see the material as it was
        bpy.ops.export_scene.gltf(filepath=str(common.FOLDER / f"{name}.glb"), export_apply=True, export_extras=True)


common.install()
moving()
subsurface()
