"""A wax Suzanne, 8 cm wide, with an area light behind her."""

import bpy
import parts


def make():
    scene = parts.empty_scene()
    parts.set_world((0.02, 0.02, 0.025))
    bpy.ops.mesh.primitive_monkey_add(size=0.058)
    head = bpy.context.object
    head.rotation_euler = (-0.3, 0, 0.45)
    parts.smooth(head, 2)
    # Her eyes are separate parts, but wax is cast in one piece.
    parts.cast(head, 0.0006, 4)
    head.data.materials.append(parts.material("Wax", (0.85, 0.62, 0.38), (0.004, 0.0025, 0.0014), roughness=0.35))
    parts.plane("Table", (0, 0, -0.0235), (0, 0, 1), 0.6, parts.material("Table", (0.35, 0.35, 0.36), roughness=0.9))
    parts.area_light("Behind", (0.08, 0.16, 0.12), (0, 0, 0.005), (0.08, 0.08), 1.2, (1, 0.95, 0.9))
    parts.area_light("Fill", (-0.25, -0.2, 0.2), (0, 0, 0), (0.15, 0.15), 0.25, (0.85, 0.9, 1))
    parts.camera((0.02, -0.22, 0.05), (0.002, 0, 0.002), 85)
    return scene
