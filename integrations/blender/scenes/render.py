"""blender -b --factory-startup --python render.py -- SCENE ENGINE FILE.exr EDGE [SAMPLES [FILE.blend]]

Makes a scene of this folder and renders a still with OPALINE or CYCLES. The add-on must be installed for the first."""

import pathlib
import sys
import time

import bpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))


def main():
    name, engine, file, edge, *rest = sys.argv[sys.argv.index("--") + 1:]
    scene = __import__(name).make()
    if engine == "OPALINE":
        bpy.ops.preferences.addon_enable(module="opaline_blender")
    else:
        bpy.ops.preferences.addon_enable(module="cycles")
    scene.render.engine = engine
    if engine == "CYCLES":
        scene.cycles.device = "CPU"
        scene.cycles.samples = int(rest[0]) if rest else 64
        scene.cycles.use_adaptive_sampling = scene.cycles.use_denoising = False
    scene.render.resolution_x = scene.render.resolution_y = int(edge)
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = str(pathlib.Path(file).absolute())
    if len(rest) > 1:
        bpy.ops.wm.save_as_mainfile(filepath=str(pathlib.Path(rest[1]).absolute()))
    begin = time.monotonic()
    bpy.ops.render.render(write_still=True)
    print(f"rendered in {time.monotonic() - begin:.1f} s")


main()
