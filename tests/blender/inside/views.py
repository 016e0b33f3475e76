"""Cameras of both kinds, what a view layer leaves out, and the scene's units."""

import pathlib
import sys

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import common

common.install()


def stage():
    """A cube and a slanted board beside it, in a collection of its own."""
    scene = common.empty_scene(48)
    scene.opaline.samples, scene.opaline.bounces = "8", 0  # as in comparisons
    common.cube("Cube", 0.03, common.matt("Cube", (0.8, 0.5, 0.3))).rotation_euler = (0.2, 0.1, 0.5)
    board = common.plane("Board", 0.03, common.matt("Board", (0.2, 0.5, 0.8)), (0.08, 0.02, 0.01))
    board.rotation_euler = (0.6, 0.3, 0)
    own = bpy.data.collections.new("Own")
    scene.collection.children.link(own)
    own.objects.link(board)
    bpy.context.collection.objects.unlink(board)
    common.lamp("SUN", (0.3, -0.5, 1), 3)
    scene.world.color = (0.2, 0.2, 0.25)
    return scene, common.camera((0.06, -0.3, 0.14)).data, own


def compare(name):
    common.compare_with_cycles(name, parts=8, samples=32)


def cameras():
    scene, view, _ = stage()
    straight = common.render("straight")
    view.shift_x, view.shift_y = 0.12, -0.07
    compare("a shifted camera")
    common.check(np.abs(common.render("shifted") - straight).max() > 0.1, "a shift moves nothing")
    scene.render.resolution_y, scene.render.pixel_aspect_x = 32, 2
    compare("wide pixels")
    scene.render.pixel_aspect_x, scene.render.pixel_aspect_y = 1, 1.5
    view.type, view.ortho_scale = "ORTHO", 0.3
    compare("a shifted orthographic camera")
    view.sensor_fit = "VERTICAL"
    compare("an orthographic camera that is as high as it says")


def layers():
    scene, _, own = stage()
    both = common.render("both")
    layer = bpy.context.view_layer.layer_collection.children[own.name]
    layer.exclude = True
    compare("what a view layer leaves out")
    alone = common.render("alone")
    common.check(np.abs(alone - both).max() > 0.1, "what a view layer leaves out is shown")
    layer.exclude = False
    again = common.render("again")
    common.check(np.allclose(again, both, rtol=0, atol=1e-4), f"what a view layer shows again differs by {np.abs(again - both).max()}")
    own.hide_render = True
    common.check(np.abs(common.render("hidden") - alone).max() < 1e-4, "a hidden collection is shown")


def units():
    """The same body in metres and in millimetres: of one size, it lets the same light through."""
    pictures = []
    for scale in (1.0, 0.001):
        scene = common.empty_scene(32)
        scene.render.pixel_aspect_y = 1
        scene.unit_settings.scale_length = scale
        body = common.cube("Body", 0.004 / scale, common.material("Body", "wholemilk"), levels=3)
        body.rotation_euler = (0.3, 0.2, 0.5)
        view = common.camera((0, -0.03 / scale, 0.01 / scale)).data
        view.clip_start, view.clip_end = 0.001 / scale, 1 / scale
        common.lamp("SUN", (0.3, 1, 0.5), 3, angle=0)
        pictures.append(common.render(f"scale_{len(pictures)}"))
    common.check(pictures[0][..., :3].max() > 0.02, "nothing is seen")
    # Places are rounded otherwise, and so is the division.
    differs = np.abs(pictures[0] - pictures[1])[..., :3].mean() / pictures[0][..., :3].mean()
    common.check(differs < 2e-3, f"a body in millimetres differs from one in metres by {differs}")


for test in (cameras, layers, units):
    test()
