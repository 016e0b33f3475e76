"""In a window: a render that Escape cancels, as an artist does it, and one after it that is whole."""

import os
import pathlib
import subprocess
import sys
import time

import bpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import common
from viewport import LONGEST_SECONDS, run_steps

ended = []  # how renders ended, in their order


def stage(edge, samples):
    scene = bpy.context.scene
    scene.render.resolution_x = scene.render.resolution_y = edge
    scene.opaline.samples = samples


def begin():
    with bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
        bpy.ops.render.render("INVOKE_DEFAULT", write_still=True)


def wait(what, until):
    begun = time.monotonic()
    while not until():
        common.check(time.monotonic() < begun + LONGEST_SECONDS, f"{what}: never")
        yield


def press_escape():
    """To the window that Blender has opened for the render."""
    window = subprocess.run(["xdotool", "search", "--onlyvisible", "--class", "blender"], capture_output=True, text=True,
                            check=True).stdout.split()[-1]
    subprocess.run(["xdotool", "windowfocus", window, "key", "Escape"], check=True)


def steps():
    common.install()
    scene = common.empty_scene()
    common.cube(half=0.02, made=common.material("Body", "jade"), levels=4)
    common.camera((0.03, -0.13, 0.02))
    common.lamp("AREA", (0.1, -0.1, 0.2), 1.0, size=0.1)
    bpy.app.handlers.render_cancel.append(lambda *_: ended.append("cancelled"))
    bpy.app.handlers.render_complete.append(lambda *_: ended.append("complete"))

    stage(3000, "8")  # far longer than a key takes
    scene.render.filepath = str(common.FOLDER / "cancelled.exr")
    begin()
    yield from wait("the first render begins", lambda: bpy.app.is_job_running("RENDER"))
    for _ in range(10):
        yield
    common.check(not ended, f"the first render has ended already: {ended}")
    press_escape()
    yield from wait("the first render ends", lambda: not bpy.app.is_job_running("RENDER"))
    common.check(ended == ["cancelled"], f"Escape did not cancel: {ended}")
    common.check(not (common.FOLDER / "cancelled.exr").exists(), "a cancelled render is written")

    stage(64, "1")
    scene.render.filepath = str(common.FOLDER / "whole.exr")
    begin()
    yield from wait("the second render ends", lambda: len(ended) == 2 and not bpy.app.is_job_running("RENDER"))
    common.check(ended[1] == "complete", f"after a cancelled render: {ended}")
    common.check(common.picture(common.FOLDER / "whole.exr")[..., :3].max() > 0.02, "after a cancelled render nothing is seen")


run_steps(steps())
