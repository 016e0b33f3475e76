"""Light spreads in a slab behind a shadow's straight edge as far as in Cycles, by each of its methods.

The walk of Cycles 4.x starts along the view, so that a slab is darker seen straight on than aslant: by what Chandrasekhar's
H functions say, 14 % for a colour of 0.4. Ours depends on the view less and on the light's angle instead, by Fresnel. So
in 4.x pictures are averaged over views, and the sun stands where as much light enters as on the mean, at 60 degrees."""

import math
import pathlib
import sys

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import common

common.install(max_surfels=65536, max_clusters=4096)


IS_NEWER = bpy.app.version >= (4, 0, 0)
EDGE = 32
# Cosines of views and their weights, for a mean by cosine: Gauss's points of cosines squared.
VIEWS = ((0.3357, 5 / 18), (0.7071, 8 / 18), (0.9420, 5 / 18)) if IS_NEWER else ((1.0, 1.0),)
SUN_DEGREES = 60 if IS_NEWER else 0


def tilted(angle, distance):
    """A place above the slab, off to the side along the shadow's edge."""
    return (0, distance * math.sin(angle), distance * math.cos(angle))


def stage(method, radius, cosine, weight=1.0, color=(0.8, 0.6, 0.4), base=(0.8, 0.6, 0.4)):
    scene = common.empty_scene(EDGE)
    scene.opaline.samples = "4"
    made = common.material("Slab", color=base, roughness=1.0, subsurface=weight, subsurface_radius=radius,
                           **{"subsurface_scale": 1.0} if IS_NEWER else {"subsurface_color": (*color, 1)})
    made.node_tree.nodes["Principled BSDF"].subsurface_method = method
    slab = common.cube("Slab", 0.04, made)
    slab.location.z = -0.04
    divided = slab.modifiers.new("Divided", "SUBSURF")
    divided.subdivision_type, divided.levels, divided.render_levels = "SIMPLE", 5, 5
    common.plane("Shade", 0.05, common.matt("Black", (0, 0, 0)), (-0.05, 0, 0.03)).scale.y = 6
    view = common.camera(tilted(-math.acos(cosine), 0.02))
    view.data.type, view.data.ortho_scale, view.data.clip_start = "ORTHO", 0.06, 1e-4
    common.lamp("SUN", tilted(math.radians(SUN_DEGREES), 1), 3 / math.cos(math.radians(SUN_DEGREES)), angle=0)


def strips(shown, cosine):
    """Along the edge, of what all of the picture's columns see of the slab."""
    rows = EDGE if cosine == 1 else int(EDGE / 2 * cosine) - 2
    return shown[(EDGE - rows) // 2:(EDGE + rows) // 2].mean(axis=0).reshape(8, -1, 3).mean(axis=1)


def compare(name, most, method, radius, **looks):
    """For each colour."""
    ours, cycles = np.zeros((8, 3)), np.zeros((8, 3))
    for cosine, weight in VIEWS:
        stage(method, radius, cosine, **looks)
        ours_here, cycles_here = common.both_engines(name, 256, bounces=4)
        ours += weight * strips(ours_here, cosine)
        cycles += weight * strips(cycles_here, cosine)
    errors = np.sqrt(((ours - cycles) ** 2).mean(axis=0)) / cycles.mean(axis=0)
    print(f"{name}: strips within {', '.join(f'{100 * error:.1f}' for error in errors)} %")
    common.check(errors.max() < most, f"{name} differs by {errors}")


adjusted, fixed = ("RANDOM_WALK_SKIN", "RANDOM_WALK") if IS_NEWER else ("RANDOM_WALK", "RANDOM_WALK_FIXED_RADIUS")
for method, radius, most in ((adjusted, (0.006, 0.004, 0.002), 0.05), (fixed, (0.03, 0.02, 0.01), 0.05),
                             ("BURLEY", (0.03, 0.02, 0.01), 0.1)):
    compare(method, most, method, radius)
if not IS_NEWER:  # whose weight scales the radius and mixes two colours
    compare("half of a weight", 0.05, fixed, (0.06, 0.04, 0.02), weight=0.5, color=(0.9, 0.3, 0.2), base=(0.7, 0.7, 0.4))
