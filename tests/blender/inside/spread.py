"""Light spreads in a slab behind a shadow's straight edge as far as in Cycles, by each of its methods."""

import pathlib
import sys

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import common

common.install(max_surfels=65536, max_clusters=4096)


IS_NEWER = bpy.app.version >= (4, 0, 0)


def stage(method, radius, weight=1.0, color=(0.8, 0.6, 0.4), base=(0.8, 0.6, 0.4)):
    scene = common.empty_scene(32)
    scene.opaline.samples = "4"
    made = common.material("Slab", color=base, roughness=1.0, subsurface=weight, subsurface_radius=radius,
                           **{"subsurface_scale": 1.0} if IS_NEWER else {"subsurface_color": (*color, 1)})
    made.node_tree.nodes["Principled BSDF"].subsurface_method = method
    slab = common.cube("Slab", 0.04, made)
    slab.location.z = -0.04
    divided = slab.modifiers.new("Divided", "SUBSURF")
    divided.subdivision_type, divided.levels, divided.render_levels = "SIMPLE", 5, 5
    common.plane("Shade", 0.05, common.matt("Black", (0, 0, 0)), (-0.05, 0, 0.03)).scale.y = 3
    view = common.camera((0, 0, 0.02))
    view.data.type, view.data.ortho_scale, view.data.clip_start = "ORTHO", 0.06, 1e-4
    common.lamp("SUN", (0, 0, 1), 3, angle=0)


def compare(name, most):
    """Strips along the edge, for each colour."""
    ours, cycles = (shown.mean(axis=0).reshape(8, -1, 3).mean(axis=1) for shown in common.both_engines(name, 256, bounces=4))
    errors = np.sqrt(((ours - cycles) ** 2).mean(axis=0)) / cycles.mean(axis=0)
    print(f"{name}: strips within {', '.join(f'{100 * error:.1f}' for error in errors)} %")
    common.check(errors.max() < most, f"{name} differs by {errors}")


adjusted, fixed = ("RANDOM_WALK_SKIN", "RANDOM_WALK") if IS_NEWER else ("RANDOM_WALK", "RANDOM_WALK_FIXED_RADIUS")
for method, radius, most in ((adjusted, (0.006, 0.004, 0.002), 0.05), (fixed, (0.03, 0.02, 0.01), 0.05),
                             ("BURLEY", (0.03, 0.02, 0.01), 0.1)):
    stage(method, radius)
    compare(method, most)
if not IS_NEWER:  # whose weight scales the radius and mixes two colours
    stage(fixed, (0.06, 0.04, 0.02), weight=0.5, color=(0.9, 0.3, 0.2), base=(0.7, 0.7, 0.4))
    compare("half of a weight", 0.05)
