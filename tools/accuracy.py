#!/usr/bin/env python3
"""Measures the figures of docs/accuracy.md for each scene: the paper's pattern against the integral that it
approximates, and that integral against light traced through the body. Prints the table and writes the heat maps; `make
accuracy` runs it. Results stay in the work folder, so that a stopped run continues; delete the folder to start
again."""

import argparse
import dataclasses
import json
import math
import pathlib
import subprocess
import sys

from repository import ROOT, models_folder

BLOCK_EDGE_PIXELS = 8
TRANSPORTS = ("dipole", "better-dipole")
# Without light that leaves and enters again, and with all of it.
BOUNCES = ("0", None)
# The truth needs only a fraction of the precision of its distance from what is compared with it.
TRUTH = ("--path", "--error", "0.08", "--seconds", "300")
INTEGRAL = ("--integral", "--tolerance", "0.01")
# Light from behind and to the side. An irradiance of π gives a white diffuser a radiance of one.
VIEW = ("--diagonal-mm", "50", "--directional", "0.45,0.35,-0.82:3.14159,3.14159,3.14159", "--size", "256x256",
        "--aov", "exitance", "--quiet")


@dataclasses.dataclass(frozen=True)
class Case:
    scene: str  # its name in the table
    source: str  # a file of the models, or a built-in scene
    medium: str
    fov_degrees: int = 30  # wide enough to show all of it
    closed: bool = True  # an open body has no inside through which light could be traced

    @property
    def name(self):
        return f"{self.scene.lower().replace(' ', '-')}-{self.medium}"


CASES = (
    Case("Bear", "bear", "marble"),
    Case("Bear", "bear", "skin1"),
    Case("Bear", "bear", "gummy-red"),
    Case("Bunny", "bunny_closed.ply", "marble"),
    Case("Bunny", "bunny_closed.ply", "skimmilk"),
    Case("Bunny", "bunny_closed.ply", "skin1"),
    Case("Egg", "bunny_egg_b.ply", "marble"),
    Case("Buddha", "buddha.ply", "marble", fov_degrees=39),
    Case("Teapot", "teapot", "marble", fov_degrees=38, closed=False),
    Case("Max Planck", "max_planck.ply", "skin1", fov_degrees=35, closed=False),
)
# Columns of the picture; all maps of a row have the same scale.
SHOWN = ("bear-marble", "bear-gummy-red", "bunny-skin1", "buddha-marble")
MAP_TOP = "1"
MAP_EDGE_PIXELS = 256


class Bench:
    """Runs the program unless the same command has been run before."""

    def __init__(self, program, models, work):
        self.program, self.models, self.work = program, models, work
        work.mkdir(parents=True, exist_ok=True)

    def scene(self, case):
        where = (str(self.models / case.source),) if "." in case.source else ("--builtin", case.source)
        return (*where, "--medium", case.medium, *VIEW, "--fov-degrees", str(case.fov_degrees))

    def image(self, name, *arguments):
        """An image and the program's report on it."""
        output, report, done = (self.work / f"{name}.{end}" for end in ("exr", "json", "command"))
        command = " ".join(arguments)
        if not (output.exists() and report.exists() and done.exists() and done.read_text() == command):
            print(name, file=sys.stderr)
            self.run(*arguments, "--report", str(report), "-o", str(output))
            done.write_text(command)
        return output, json.loads(report.read_text())

    def run(self, *arguments):
        return subprocess.run([self.program, *arguments], check=True, stdout=subprocess.PIPE).stdout

    def compare(self, a, b, *options):
        return json.loads(self.run("compare", str(a), str(b), "--json", "--quiet", *options))


def truth_error(block_error, compared):
    """The standard error that a truth reports, converted to what `compare --block` measures. The truth divides by the
    mean block, the comparison by the larger mean of the covered pixels: blocks at the outline are not full."""
    return block_error * compared["covered_pixels"] / (compared["block"]["covered_blocks"] * BLOCK_EDGE_PIXELS**2)


def without_noise(distance, noise):
    """The distance without the noise: independent errors add as squares."""
    return math.sqrt(max(distance**2 - noise**2, 0))


def measure(bench, case):
    """The figures of a row as shares."""
    scene = bench.scene(case)
    pattern, _ = bench.image(f"{case.name}-pattern", "render", *scene, "--method", "paper")
    integrals = {transport: bench.image(f"{case.name}-{transport}", "reference", *scene, *INTEGRAL,
                                        "--transport", transport)[0] for transport in TRANSPORTS}
    compared = bench.compare(pattern, integrals["dipole"], "--block", str(BLOCK_EDGE_PIXELS))
    block = compared["block"]
    row = {"pattern": compared["rel_rmse"], "on_body": block["covered_blocks"] / block["blocks"], "noise": []}
    if not case.closed:
        return row
    for bounces in BOUNCES:
        limited = () if bounces is None else ("--bounces", bounces)
        truth, report = bench.image(f"{case.name}-path-{bounces or 'default'}", "reference", *scene, *TRUTH, *limited)
        for transport in TRANSPORTS:
            compared = bench.compare(integrals[transport], truth, "--block", str(BLOCK_EDGE_PIXELS))
            noise = truth_error(report["block_error"], compared)
            row[transport, bounces] = without_noise(compared["block"]["covered_rel_rmse"], noise)
            row[transport, "too dark"] = -compared["rel_bias"]  # of the last one, which has all light
        row["noise"].append(noise)
    return row


def percent(shares):
    """One or two figures in percent; digits beyond the second carry no information."""
    return " / ".join(f"{100 * share:.{1 if abs(share) < .1 else 0}f}" for share in shares) + " %" if shares else "–"


def table(rows):
    """The table as Markdown; rows are pairs of a case and its figures."""
    lines = ["| scene | medium | pattern to integral | dipole to path | better dipole to path | too dark by "
             "| the path's own | body |", "|" + "---|" * 8]
    for case, row in rows:
        cells = [case.scene, case.medium, percent([row["pattern"]]),
                 *(percent([row[transport, bounces] for bounces in BOUNCES] if case.closed else [])
                   for transport in TRANSPORTS),
                 percent([row[transport, "too dark"] for transport in TRANSPORTS] if case.closed else []),
                 percent(row["noise"]), percent([row["on_body"]])]
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def draw(bench, output):
    """The heat maps: above the pattern against the integral, per pixel; below the integral against the path, per
    block."""
    maps = []
    for kind, a, b, options in (("pixels", "pattern", "dipole", ()),
                                ("blocks", "dipole", "path-default", ("--block", str(BLOCK_EDGE_PIXELS)))):
        for name in SHOWN:
            maps.append(bench.work / f"{name}-{kind}.png")
            bench.compare(bench.work / f"{name}-{a}.exr", bench.work / f"{name}-{b}.exr", *options,
                          "--heatmap", str(maps[-1]), "--heatmap-max", MAP_TOP)
    columns = len(SHOWN)
    # Only the last map of a row keeps its scale.
    filters = [f"[{i}]crop={MAP_EDGE_PIXELS}:{MAP_EDGE_PIXELS}:0:0[m{i}]" if (i + 1) % columns else f"[{i}]copy[m{i}]"
               for i in range(len(maps))]
    for row in range(2):
        filters.append("".join(f"[m{row * columns + i}]" for i in range(columns)) + f"hstack={columns}[r{row}]")
    filters.append("[r0][r1]vstack")
    inputs = [argument for file in maps for argument in ("-i", str(file))]
    subprocess.run(["ffmpeg", "-loglevel", "error", "-y", *inputs, "-filter_complex", ";".join(filters),
                    "-q:v", "3", "-pix_fmt", "yuvj444p", str(output)], check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default=str(ROOT / "build" / "release" / "bin" / "opaline"))
    parser.add_argument("--models", type=pathlib.Path, help="[OPALINE_MODELS, else ../shared/models]",
                        default=models_folder())
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "accuracy")
    parser.add_argument("--picture", type=pathlib.Path,
                        default=ROOT / "docs" / "images" / "accuracy_scenes.jpg")
    arguments = parser.parse_args()
    bench = Bench(arguments.program, arguments.models, arguments.work)
    try:
        rows = [(case, measure(bench, case)) for case in CASES]
        draw(bench, arguments.picture)
    except (subprocess.CalledProcessError, OSError) as error:
        sys.exit(f"accuracy: {error}")
    print(table(rows))


if __name__ == "__main__":
    main()
