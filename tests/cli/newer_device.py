"""The software device that scripts/fetch-ray-query-device.sh adds to the system's."""

import os
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "build" / "ray-query-device"
IS_THERE = (FOLDER / "device.json").exists()
WHY_NOT = f"no {FOLDER}: scripts/fetch-ray-query-device.sh says why"
ENVIRONMENT = {**os.environ, "VK_DRIVER_FILES": str(FOLDER / "device.json"), "LD_LIBRARY_PATH": str(FOLDER)}
