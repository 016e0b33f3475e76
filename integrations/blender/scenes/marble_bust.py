"""A marble bust, 40 cm high, in front of a window."""

import bpy
import parts

# Middle, half axes and turn about x of the ellipsoids that form the bust, in metres.
ELLIPSOIDS = (
    ((0, 0, 0.30), (0.075, 0.092, 0.105), 0.0),  # skull
    ((0, -0.045, 0.255), (0.058, 0.055, 0.068), 0.0),  # face
    ((0, -0.098, 0.275), (0.012, 0.024, 0.034), -0.35),  # nose
    ((0, -0.080, 0.215), (0.030, 0.028, 0.022), 0.0),  # chin
    ((0.030, -0.086, 0.305), (0.022, 0.014, 0.010), 0.0),  # brows
    ((-0.030, -0.086, 0.305), (0.022, 0.014, 0.010), 0.0),
    ((0.077, 0.005, 0.275), (0.010, 0.022, 0.034), 0.15),  # ears
    ((-0.077, 0.005, 0.275), (0.010, 0.022, 0.034), 0.15),
    ((0, 0.050, 0.335), (0.060, 0.055, 0.050), 0.0),  # hair
    ((0, 0.012, 0.165), (0.048, 0.050, 0.090), 0.12),  # neck
    ((0, 0.020, 0.055), (0.165, 0.080, 0.065), 0.0),  # shoulders
    ((0, -0.010, 0.010), (0.105, 0.075, 0.080), 0.0),  # chest
    ((0, 0.005, -0.075), (0.060, 0.060, 0.035), 0.0),  # foot
)


def make():
    scene = parts.empty_scene()
    parts.set_world((0.05, 0.055, 0.065))
    pieces = []
    for place, axes, turn in ELLIPSOIDS:
        bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=4, radius=1, location=place, rotation=(turn, 0, 0), scale=axes)
        pieces.append(bpy.context.object)
    bust = parts.joined(pieces, "Bust")
    parts.cast(bust, 0.0045, 6)
    bust.rotation_euler = (0, 0, 0.5)
    bust.data.materials.append(parts.material("Marble", (0.83, 0.79, 0.75), (0.0085, 0.0056, 0.0040), roughness=0.3))
    parts.plane("Sill", (0, 0, -0.11), (0, 0, 1), 2, parts.material("Sill", (0.45, 0.40, 0.34), roughness=0.8))
    parts.area_light("Window", (0.75, 0.35, 0.55), (0, 0, 0.15), (0.7, 1.0), 18, (0.9, 0.95, 1))
    parts.camera((-0.28, -1.35, 0.30), (0, 0, 0.15), 85)
    return scene
