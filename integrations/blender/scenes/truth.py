"""blender -b --factory-startup --python truth.py -- SCENE TRUTH.exr FOUND.exr EDGE SECONDS

Follows light through a scene of this folder, by the path reference of the Python module, and makes the same picture
by the renderer, of the first object alone. Neither has the reflection on its surface. The add-on must be installed."""

import pathlib
import sys

import bpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))


def main():
    name, truth_file, found_file, edge, seconds = sys.argv[sys.argv.index("--") + 1:]
    scene = __import__(name).make()
    bpy.ops.preferences.addon_enable(module="opaline_blender")
    import opaline
    from opaline_blender import final, live, units
    from opaline_blender.notes import Notes
    from opaline_blender.reading import camera, snapshot

    scene.render.engine = "OPALINE"
    scene.render.resolution_x = scene.render.resolution_y = int(edge)
    depsgraph = bpy.context.evaluated_depsgraph_get()
    mm_per_unit = units.mm_per_unit(scene)
    seen = snapshot.Reader(depsgraph, mm_per_unit, Notes()).read()
    made = live.scene_of(seen)
    width, height, part = final.picture_size(scene)
    made.camera = camera.camera_of(*final.matrices_of(depsgraph, scene, width, height, part), mm_per_unit)
    truth = opaline.path(made, width, height, "radiance", longest_seconds=float(seconds), error=0.001, specular=False)
    opaline.write_exr(truth_file, truth["radiance"])
    print("block error of the truth", truth.facts.get("block_error"))
    found = opaline.Renderer(made).render(width, height, ["radiance", "object"], specular=False)
    body = found["radiance"].copy()
    body[found["object"][..., 0] != 0] = 0
    opaline.write_exr(found_file, body)


main()
