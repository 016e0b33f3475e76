"""What modifiers, shape keys, particles and instances make of a mesh is rendered as in Cycles, and several materials of one object."""

import pathlib
import sys

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import common

common.install()
EDGE = 64


def stage():
    scene = common.empty_scene(EDGE)
    scene.opaline.samples = "8"
    common.camera((0.05, -0.22, 0.12))
    common.lamp("SUN", (0.3, -0.5, 1), 3)
    scene.world.color = (0.2, 0.2, 0.25)



def compare(name):
    common.compare_with_cycles(name, parts=8, samples=32)


def shape_keys():
    stage()
    body = common.cube(half=0.03, made=common.matt("Matt", (0.8, 0.5, 0.3)))
    body.shape_key_add(name="Basis")
    drawn = body.shape_key_add(name="Drawn")
    for point in drawn.data:
        if point.co.z > 0:
            point.co = (0.3 * point.co.x + 0.02, 0.3 * point.co.y, 2 * point.co.z)
    drawn.value = 0.0
    before = common.render("key_0")
    drawn.value = 0.7
    compare("a shape key")
    # The same renderer follows: its picture is that of one that knows only this moment, but for rounding.
    followed = common.render("key_followed")
    common.check(np.abs(followed - before).max() > 0.05, "a shape key changes nothing")
    from opaline_blender import final
    final.forget()
    common.check(np.allclose(followed, common.render("key_anew"), rtol=0, atol=1e-6), "a key that was followed looks otherwise than anew")


def bones():
    """The cage bends, and the surface is subdivided after it."""
    stage()
    body = common.column("Column", 0.025, common.matt("Matt", (0.8, 0.5, 0.3)), levels=3)
    rig = common.rig_of(body, 0.05)
    with bpy.context.temp_override(object=body):
        bpy.ops.object.modifier_move_to_index(modifier="Armature", index=0)
    straight = common.render("straight")
    rig.pose.bones["Tip"].rotation_euler = (0.9, 0, 0.3)
    compare("an armature")
    common.check(np.abs(common.render("bent") - straight).max() > 0.05, "a bone moves nothing")


def particles():
    stage()
    piece = common.cube("Piece", 0.006, common.matt("Piece", (0.2, 0.6, 0.8)))
    piece.location = (0, 0, -5)  # the original, out of sight
    emitter = common.plane("Emitter", 0.06)
    emitter.show_instancer_for_render = False
    emitter.modifiers.new("Particles", "PARTICLE_SYSTEM")
    settings = emitter.particle_systems[0].settings
    settings.count, settings.frame_start, settings.frame_end, settings.lifetime = 40, 1, 1, 100
    settings.physics_type, settings.emit_from = "NO", "FACE"
    settings.render_type, settings.instance_object, settings.particle_size = "OBJECT", piece, 1.0
    settings.use_scale_instance = True
    bpy.context.scene.frame_set(2)
    compare("particles")
    shown = common.render("particles")[..., :3]
    common.check((np.abs(shown - (0.2, 0.2, 0.25)).max(axis=2) > 0.02).mean() > 0.05, "no particle is seen")


def instances():
    stage()
    holder = common.cube("Holder", 0.05)
    child = common.cube("Child", 0.012, common.matt("Child", (0.7, 0.7, 0.2)))
    child.parent = holder
    holder.instance_type = "VERTS"
    holder.show_instancer_for_render = False
    compare("instances at vertices")
    holder.instance_type = "FACES"
    compare("instances at faces")


def slots():
    """Faces of one object in different colours, by slots of the mesh and of the object."""
    stage()
    body = common.cube(half=0.04, made=common.matt("First", (0.8, 0.1, 0.1)))
    body.data.materials.append(common.matt("Second", (0.1, 0.7, 0.1)))
    body.data.materials.append(common.matt("Third", (0.1, 0.2, 0.9)))
    body.material_slots[2].link = "OBJECT"
    body.material_slots[2].material = common.matt("Of the object", (0.8, 0.8, 0.1))
    body.rotation_euler = (0.2, 0.1, 0.4)
    for face, slot in enumerate((0, 1, 2, 1, 0, 2)):
        body.data.polygons[face].material_index = slot
    compare("three materials")
    # What light enters beside what it does not.
    body.material_slots[1].material.opaline.medium_item = "wax" if "wax" in medium_names() else "marble"
    mixed = common.render("mixed")
    common.check(np.isfinite(mixed).all() and mixed[..., :3].max() > 0.05, "a body of two kinds of material is not shown")


def medium_names():
    import opaline
    return opaline.media()


for test in (shape_keys, bones, particles, instances, slots):
    test()
