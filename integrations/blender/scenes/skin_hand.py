"""A hand of skin that an armature moves, 18 cm long, with light from behind the fingers."""

import math

import bpy
import parts
from mathutils import Vector

# For each finger: its root, its direction in the palm's plane, the lengths of its bones and its thickness, in metres.
FINGERS = {
    "thumb": ((-0.030, 0.012), (-0.75, 0.66), (0.034, 0.028), 0.0105),
    "index": ((-0.026, 0.085), (-0.10, 1.0), (0.040, 0.024, 0.018), 0.0088),
    "middle": ((-0.007, 0.090), (-0.01, 1.0), (0.044, 0.027, 0.019), 0.0090),
    "ring": ((0.012, 0.086), (0.07, 1.0), (0.040, 0.025, 0.018), 0.0085),
    "little": ((0.029, 0.077), (0.17, 1.0), (0.031, 0.019, 0.016), 0.0075),
}
WRIST = (0.0, -0.02)


def joints(name):
    """Places along a finger, from its root."""
    (x, y), (dx, dy), lengths, _ = FINGERS[name]
    norm = math.hypot(dx, dy)
    places = [(x, y, 0.0)]
    for length in lengths:
        x, y = x + length * dx / norm, y + length * dy / norm
        places.append((x, y, 0.0))
    return places


def limb(start, end, thick_at_start, thick_at_end):
    """A ball at either end and a cone between them."""
    start, end = (Vector((place[0], place[1], 0)) for place in (start, end))
    along = end - start
    for place, radius in ((start, thick_at_start), (end, thick_at_end)):
        bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=3, radius=radius, location=place)
        yield bpy.context.object
    bpy.ops.mesh.primitive_cone_add(vertices=24, radius1=thick_at_start, radius2=thick_at_end, depth=along.length,
                                    location=(start + end) / 2, rotation=along.to_track_quat("Z", "Y").to_euler())
    yield bpy.context.object


def pieces():
    """Fingers of cones, and a palm made of a flat ball below each finger."""
    for name, (root, _, lengths, thickness) in FINGERS.items():
        places = joints(name)
        for i in range(len(lengths)):
            yield from limb(places[i], places[i + 1], thickness * (1.05 - 0.1 * i), thickness * (0.95 - 0.1 * i))
        yield from limb(WRIST, root, 0.013, 1.1 * thickness)
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=4, radius=1, location=(0, 0.04, 0), scale=(0.036, 0.056, 0.012))
    yield bpy.context.object
    yield from limb((0, -0.07), WRIST, 0.019, 0.017)


def body():
    hand = parts.joined(list(pieces()), "Hand")
    parts.cast(hand, 0.0018, 12)
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
    weigh(hand, bones)
    hand.modifiers.new("Bones", "ARMATURE").object = rig
    hand.parent = rig
    return rig


def weigh(hand, bones):
    """Each vertex follows the nearest bones; nearer ones count more."""
    groups = {bone.name: hand.vertex_groups.new(name=bone.name) for bone in bones.bones}
    for vertex in hand.data.vertices:
        near = []
        for bone in bones.bones:
            head, tail = bone.head_local, bone.tail_local
            along = max(0.0, min(1.0, (vertex.co - head).dot(tail - head) / (tail - head).length_squared))
            near.append(((vertex.co - head.lerp(tail, along)).length ** -6, bone.name))
        near = sorted(near, reverse=True)[:3]
        for weight, name in near:
            groups[name].add([vertex.index], weight / sum(one for one, _ in near), "REPLACE")


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
