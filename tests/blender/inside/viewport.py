"""In a window: the viewport's rendered mode while the view turns, a colour changes, a lamp moves and time passes."""

import os
import pathlib
import subprocess
import sys
import time

import bpy
import numpy as np
from mathutils import Quaternion

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import common

LONGEST_SECONDS = 240


def view_area():
    return next(area for area in bpy.context.window_manager.windows[0].screen.areas if area.type == "VIEW_3D")


def shot(name):
    """What the display shows of the window's view: array (height, width, 3). Blender 4.3's own screenshots are black on Mesa's
    software device."""
    window, region = bpy.context.window_manager.windows[0], next(part for part in view_area().regions if part.type == "WINDOW")
    file = common.FOLDER / f"{name}.png"
    subprocess.run(["import", "-silent", "-window", "root", file], check=True)
    display = common.picture(file)[..., :3]
    common.check(display.shape[:2] == (window.height, window.width), f"the window does not fill the display: {display.shape}")
    top = window.height - region.y - region.height
    return display[top:top + region.height, region.x:region.x + region.width]


def middle(shown):
    """Without the header, its buttons and the grid's names."""
    height, width = shown.shape[:2]
    return shown[height // 4:3 * height // 4, width // 4:3 * width // 4]


def differs(before, after):
    return float(np.abs(middle(before) - middle(after)).mean())


def is_fine(shown):
    """Whether an edge is as sharp as in the last of the pictures that get finer: in that before it, steps are half as high."""
    return np.abs(np.diff(middle(shown), axis=1)).max() > 0.2


def stage():
    scene = common.empty_scene()
    scene.view_settings.view_transform = "Filmic"  # the default of 3.x, in which edges are as sharp as is_fine() knows
    body = common.cube(half=0.02, made=common.material("Body", "jade"), levels=2)
    common.plane(half=0.06, made=common.material("Floor", color=(0.5, 0.2, 0.1)), place=(0, 0, -0.02))
    common.lamp("AREA", (0.1, -0.1, 0.2), 1.0, size=0.1)
    for frame, height in ((1, 0.0), (40, 0.06)):
        body.location.z = height
        body.keyframe_insert("location", frame=frame)
    scene.frame_start, scene.frame_end = 1, 40
    scene.frame_set(1)
    scene.world.color = (0.1, 0.15, 0.3)
    area = view_area()
    space = area.spaces.active
    space.overlay.show_overlays = space.show_region_toolbar = space.show_region_ui = space.show_gizmo = False
    space.shading.type = "RENDERED"
    view = space.region_3d
    view.view_perspective = "PERSP"
    view.view_location = (0, 0, 0)
    view.view_distance = 0.16
    view.view_rotation = Quaternion((0.8, 0.5, 0.15, 0.2)).normalized()
    return body, view


def turn(view):
    view.view_rotation = Quaternion((0.75, 0.5, 0.3, 0.35)).normalized()


def steps():
    """Yields between what it does, until the window has had time to draw."""
    common.install()
    body, view = stage()
    before = yield from settled("begin", lambda shown: middle(shown).std() > 0.03 and is_fine(shown))
    changes = (
        ("turned", lambda: turn(view)),
        ("floor", lambda: set_color((0.05, 0.5, 0.1, 1))),
        ("lamp", lambda: setattr(bpy.data.objects["Area"], "location", (-0.2, -0.1, 0.05))),
        ("medium", lambda: setattr(bpy.data.materials["Body"].opaline, "medium_item", "ketchup")),
        ("orthographic", lambda: setattr(view, "view_perspective", "ORTHO")),
    )
    for name, change in changes:
        change()
        before = yield from settled(name, lambda shown, old=before: differs(old, shown) > 0.004)
    with bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
        bpy.ops.screen.animation_play()
        begin = time.monotonic()
        while bpy.context.scene.frame_current < 10 and time.monotonic() - begin < LONGEST_SECONDS:
            yield
        bpy.ops.screen.animation_cancel(restore_frame=False)
    bpy.context.scene.frame_set(20)
    # The red body is nearer than the place from which Blender looks along parallel lines.
    yield from settled("played", lambda shown: (shown[..., 0] - shown[..., 1] > 0.05)[shown.shape[0] // 6:shown.shape[0] // 2].any())


def set_color(color):
    bpy.data.materials["Floor"].node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = color


def settled(name, is_right):
    """Waits until the view shows what it should and comes to rest; returns the shot."""
    begin, before = time.monotonic(), None
    while time.monotonic() < begin + LONGEST_SECONDS:
        wait = time.monotonic() + 1.5
        while time.monotonic() < wait:
            yield
        after = shot(name)
        rests = before is not None and before.shape == after.shape and np.abs(before - after).max() < 0.01
        if rests and is_right(after):
            return after
        before = after
    common.check(False, f"{name}: the viewport did not follow, or does not come to rest")


def run_steps(work):
    """One after the other, each once the window has had time to draw. Ends Blender."""
    def step():
        try:
            next(work)
        except StopIteration:
            print("DONE")
            sys.stdout.flush()
            os._exit(0)
        except Exception:
            import traceback

            traceback.print_exc()
            sys.stderr.flush()
            os._exit(4)
        return 0.1

    bpy.context.preferences.view.show_splash = False
    bpy.app.timers.register(step, first_interval=1)


if __name__ == "__main__":
    run_steps(steps())
