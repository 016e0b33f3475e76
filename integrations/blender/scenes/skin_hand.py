"""A hand of skin that an armature moves, 18 cm long, with light from behind the fingers."""

import math

import bpy
import parts

# Of each finger: where it begins, its direction in the palm's plane, the lengths of its bones and its thickness, metres.
FINGERS = {
    "thumb": ((-0.030, 0.012), (-0.75, 0.66), (0.034, 0.028), 0.0105),
    "index": ((-0.026, 0.085), (-0.10, 1.0), (0.040, 0.024, 0.018), 0.0088),
    "middle": ((-0.007, 0.090), (-0.01, 1.0), (0.044, 0.027, 0.019), 0.0090),
    "ring": ((0.012, 0.086), (0.07, 1.0), (0.040, 0.025, 0.018), 0.0085),
    "little": ((0.029, 0.077), (0.17, 1.0), (0.031, 0.019, 0.016), 0.0075),
}
WRIST = (0.0, -0.02)


def joints(name):
    """Along a finger, from its root."""
    (x, y), (dx, dy), lengths, _ = FINGERS[name]
    norm = math.hypot(dx, dy)
    places = [(x, y, 0.0)]
    for length in lengths:
        x, y = x + length * dx / norm, y + length * dy / norm
        places.append((x, y, 0.0))
    return places


def skeleton():
    """The hand's edges, and how thick it is at each."""
    vertices, edges, radii = [(*WRIST, 0), (0, 0.03, 0)], [(0, 1)], [(0.026, 0.015), (0.033, 0.013)]
    for name, (_, _, _, thickness) in FINGERS.items():
        before = 1 if name != "thumb" else 0
        for i, place in enumerate(joints(name)):
            vertices.append(place)
            radii.append((thickness * (1.08 - 0.1 * i),) * 2)
            edges.append((before, len(vertices) - 1))
            before = len(vertices) - 1
    return vertices, edges, radii


def body():
    vertices, edges, radii = skeleton()
    mesh = bpy.data.meshes.new("Hand")
    mesh.from_pydata(vertices, edges, [])
    hand = parts.add("Hand", mesh)
    bpy.context.view_layer.objects.active = hand
    hand.select_set(True)
    hand.modifiers.new("Skin", "SKIN").use_smooth_shade = True
    for layer, radius in zip(mesh.skin_vertices[0].data, radii):
        layer.radius = radius
    mesh.skin_vertices[0].data[0].use_root = True
    remesh = hand.modifiers.new("Remesh", "REMESH")
    remesh.mode, remesh.voxel_size, remesh.use_smooth_shade = "VOXEL", 0.0022, True
    hand.modifiers.new("Smooth", "SMOOTH").iterations = 8
    for name in [modifier.name for modifier in hand.modifiers]:
        bpy.ops.object.modifier_apply(modifier=name)
    return hand


def armature(hand):
    bones = bpy.data.armatures.new("Bones")
    rig = parts.add("Bones", bones)
    bpy.ops.object.select_all(action="DESELECT")
    bpy.context.view_layer.objects.active = rig
    rig.select_set(True)
    bpy.ops.object.mode_set(mode="EDIT")
    palm = bones.edit_bones.new("palm")
    palm.head, palm.tail = (*WRIST, 0), (0, 0.06, 0)
    for name in FINGERS:
        before, places = palm, joints(name)
        for i in range(len(places) - 1):
            bone = bones.edit_bones.new(f"{name}.{i}")
            bone.head, bone.tail, bone.parent = places[i], places[i + 1], before
            before = bone
    bpy.ops.object.mode_set(mode="OBJECT")
    hand.select_set(True)
    bpy.ops.object.parent_set(type="ARMATURE_AUTO")
    return rig


def make():
    scene = parts.empty_scene(frames=24)
    parts.set_world((0.03, 0.03, 0.035))
    hand = body()
    rig = armature(hand)
    for name in FINGERS:
        for i in range(len(joints(name)) - 1):
            bone = rig.pose.bones[f"{name}.{i}"]
            bone.rotation_mode = "XYZ"
            for frame, bend in ((1, 0.12), (24, 0.75)):
                bone.rotation_euler = (bend * (0.5 if name == "thumb" else 1) * (0.7 + 0.2 * i), 0, 0)
                bone.keyframe_insert("rotation_euler", frame=frame)
    rig.rotation_euler = (math.radians(90), 0, math.radians(20))
    hand.data.materials.append(parts.material("Skin", (0.75, 0.45, 0.33), (0.0037, 0.0014, 0.0007), roughness=0.45))
    parts.area_light("Behind", (0.10, 0.22, 0.12), (0, 0, 0.06), (0.10, 0.10), 2.2)
    parts.area_light("Front", (-0.22, -0.30, 0.24), (0, 0, 0.06), (0.2, 0.2), 1.2, (1, 0.95, 0.9))
    parts.camera((0, -0.55, 0.07), (-0.005, 0, 0.062), 85)
    scene.frame_set(12)
    return scene
