"""Without a Vulkan device there is a sentence."""

import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import common

common.install()
common.empty_scene(16)
common.cube()
common.camera()
try:
    common.render()
except RuntimeError as error:
    print(f"SAID: {error}", flush=True)
    os._exit(0)  # Blender itself ends with 1 after a failed render
else:
    common.check(False, "a picture without a device")
