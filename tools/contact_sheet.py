#!/usr/bin/env python3
"""Renders every model of a folder, and ten awkward bodies, in several media and sizes, into one sheet of small pictures
for inspection. Prints the time of each, and fails where one took too long, ended badly, or has a value that is not a
number. Time is processor time, so other load does not matter. `make contact-sheet` runs it. Results stay in the work
folder; delete it to start again."""

import argparse
import array
import json
import pathlib
import resource
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "tests" / "cli"))

import images
from awkward_bodies import BODIES, write_obj
from repository import ROOT, models_folder

ENDS = (".glb", ".gltf", ".obj", ".ply", ".toml")


def models(folders, work):
    """Every model below the folders, and our own bodies, which are written into the work folder."""
    found = [path for folder in folders for path in sorted(folder.rglob("*")) if path.suffix in ENDS]
    bodies = work / "bodies"
    bodies.mkdir(parents=True, exist_ok=True)
    for name, body in BODIES.items():
        path = bodies / f"{name}.obj"
        write_obj(path, body)
        found.append(path)
    return found


def processor_seconds():
    """The processor time of all programs that were started here and have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def render(program, model, medium, diagonal, options, output, limit):
    """The time in seconds, and what is wrong, if anything."""
    begin = time.monotonic()
    try:
        done = subprocess.run([program, "render", str(model), "--medium", medium, "--diagonal-mm", str(diagonal), *options,
                               "-o", str(output)], capture_output=True, text=True, timeout=2 * limit, check=False)
    except subprocess.TimeoutExpired:
        return 2 * limit, f"took more than {2 * limit} s"
    seconds = time.monotonic() - begin
    if done.returncode != 0:
        return seconds, done.stderr.strip().splitlines()[-1] if done.stderr.strip() else f"status {done.returncode}"
    picture = images.read_exr(output.read_bytes())
    if any(not abs(value) < 1e30 for pixel in picture.pixels() for value in pixel[:3]):
        return seconds, "has a value that is no number"
    if not any(max(pixel[:3]) > 0 for pixel in picture.covered()):
        return seconds, "is black"
    return seconds, f"took {seconds:.0f} s" if seconds > limit else None


def tone(exr, png):
    """The picture as a screen shows it. The brightest hundredth of the body is white."""
    picture = images.read_exr(exr.read_bytes())
    bright = sorted(max(pixel[:3]) for pixel in picture.covered()) or [1]
    scale = 1 / (bright[int(.99 * (len(bright) - 1))] or 1)
    values = array.array("B", (round(255 * min(max(c * scale, 0), 1) ** (1 / 2.2)) if a > 0 else 20
                               for r, g, b, a in picture.pixels() for c in (r, g, b)))
    ppm = b"P6 %d %d 255\n" % (picture.width, picture.height) + values.tobytes()
    subprocess.run(["convert", "ppm:-", str(png)], input=ppm, check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default=str(ROOT / "build" / "release" / "bin" / "opaline"))
    parser.add_argument("--models", type=pathlib.Path, nargs="*", default=[models_folder()])
    parser.add_argument("--only", nargs="*", help="names of models to render, without their ending [all]")
    parser.add_argument("--media", nargs="*", help="[every built-in medium]")
    parser.add_argument("--diagonals-mm", type=float, nargs="*", default=[5, 50, 500])
    parser.add_argument("--every", type=int, default=1, help="of each model, renders one in so many of media and sizes, "
                        "others of the next model [1]")
    parser.add_argument("--size", type=int, default=128, help="edge of a picture in pixels [128]")
    parser.add_argument("--limit", type=float, default=60, help="seconds that one may take [60]")
    parser.add_argument("--columns", type=int, default=12)
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "contact-sheet")
    parser.add_argument("--options", nargs=argparse.REMAINDER, default=[], help="handed on to the program; last")
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    media = arguments.media or [medium["name"] for medium in json.loads(
        subprocess.run([arguments.program, "media", "--json"], check=True, capture_output=True).stdout)["media"]]
    options = ("--size", f"{arguments.size}x{arguments.size}", "--aov", "exitance", "--quiet", *arguments.options)
    font = subprocess.run(["fc-match", "-f", "%{file}", "sans"], check=True, capture_output=True, text=True).stdout
    wrong, times = [], []
    bodies = [model for model in models(arguments.models, arguments.work)
              if not arguments.only or model.stem in arguments.only]
    for m, medium in enumerate(media):
        for d, diagonal in enumerate(arguments.diagonals_mm):
            tiles = []
            for model in bodies[-(m + d) % arguments.every::arguments.every]:
                name = f"{model.stem}{model.suffix.replace('.', '_')}-{medium}-{diagonal:g}"
                exr, png, took = (arguments.work / f"{name}.{end}" for end in ("exr", "png", "seconds"))
                if not took.exists():
                    before = processor_seconds()
                    seconds, fault = render(arguments.program, model, medium, diagonal, options, exr, arguments.limit)
                    took.write_text(json.dumps([seconds, processor_seconds() - before, fault]))
                    if exr.exists():
                        tone(exr, png)
                seconds, processor, fault = json.loads(took.read_text())
                times.append((processor, seconds, name))
                if fault:
                    wrong.append(f"{name}: {fault}")
                tiles += ["-label", f"{model.stem[:18]} {seconds:.1f}s", str(png) if png.exists() else "xc:red"]
            if not tiles:
                continue
            sheet = arguments.work / f"sheet-{medium}-{diagonal:g}.png"
            subprocess.run(["montage", "-font", font, "-pointsize", "10", *tiles, "-tile", f"{arguments.columns}x", "-geometry",
                            f"{arguments.size}x{arguments.size}+2+2", str(sheet)], check=True)
            print(sheet)
    slowest = sorted(times, reverse=True)[:5]
    print("most processor time: " + ", ".join(f"{name} {processor:.0f} s, {seconds:.0f} s by the clock"
                                              for processor, seconds, name in slowest))
    for line in wrong:
        print(line, file=sys.stderr)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
