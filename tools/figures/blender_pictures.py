#!/usr/bin/env python3
"""blender_pictures.py --into FOLDER [--edge N] [--samples N]

Renders the scenes of integrations/blender/scenes in Blender by Opaline and by Cycles, says how long each took, and puts the
pictures side by side as blender_scenes.png. Needs Blender and ffmpeg."""

import argparse
import os
import pathlib
import re
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ROOT / "integrations" / "blender" / "scenes"
NAMES = ("wax_suzanne", "skin_hand", "marble_bust")
ENGINES = ("OPALINE", "CYCLES")


def blender(home, *words):
    """The program's output. It runs with no settings but those of this run, and with the system's Python."""
    environment = {**os.environ, "HOME": str(home), "XDG_CONFIG_HOME": str(home / ".config"), "PATH": "/usr/bin:/bin"}
    done = subprocess.run(["blender", "-b", "--factory-startup", "--python-exit-code", "1", *map(str, words)],
                          env=environment, capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(done.stdout + done.stderr)
    return done.stdout


def install(home):
    archive = next((ROOT / "build" / "release").glob("opaline_blender-*.zip"), None)
    if archive is None:
        raise SystemExit("there is no add-on: run make blender")
    blender(home, "--python-expr", f"import bpy; bpy.ops.preferences.addon_install(filepath={str(archive)!r})")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--into", type=pathlib.Path, required=True)
    parser.add_argument("--edge", type=int, default=400, help="pixels [400]")
    parser.add_argument("--samples", type=int, default=256, help="of Cycles [256]")
    arguments = parser.parse_args()
    into = arguments.into.resolve()
    with tempfile.TemporaryDirectory() as temporary:
        home = pathlib.Path(temporary)
        install(home)
        rows = []
        for engine in ENGINES:
            for name in NAMES:
                picture = into / f"{name}_{engine.lower()}.exr"
                said = blender(home, "--python", SCENES / "render.py", "--", name, engine, picture, arguments.edge, arguments.samples)
                print(f"{name} {engine.lower()} {re.search('rendered in (.*)', said)[1]}", flush=True)
                rows.append(picture)
    inputs = [word for picture in rows for word in ("-apply_trc", "iec61966_2_1", "-i", picture)]
    grid = "[0][1][2]hstack=3[a];[3][4][5]hstack=3[b];[a][b]vstack=2,format=rgb24"
    subprocess.run(["ffmpeg", "-loglevel", "error", "-y", *inputs, "-filter_complex", grid, "-frames:v", "1", "-update", "1",
                    into / "blender_scenes.png"], check=True)


if __name__ == "__main__":
    main()
