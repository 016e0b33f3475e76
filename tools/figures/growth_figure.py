#!/usr/bin/env python3
"""Draws growth.svg: the time for awkward files of growing size, as measured by opaline_growth_bench."""

import argparse
import json
import math
import os
import pathlib
import subprocess

STAGES = {"read": ("read",), "surfels and clusters": ("insides", "surfels", "clusters"), "the paper's atlas": ("atlas",)}
COLORS = ("#2b5fc0", "#c0392b", "#2e8b57", "#8e44ad", "#d68910", "#16a0a0", "#7f5f3f", "#e056a0", "#555555")
PANEL, GAP, LEFT, TOP, HEIGHT = 220, 44, 60, 52, 330
LEAST, MOST = 0.01, 20.0  # seconds
WIDTH = LEFT + 3 * PANEL + 2 * GAP + 120


def measured():
    bench = pathlib.Path(os.environ["OPALINE"]).with_name("opaline_growth_bench")
    return json.loads(subprocess.run([bench, "--json"], check=True, capture_output=True, text=True).stdout)


def times(rows, family, stages):
    """The sum of these stages at each size."""
    chosen = [row["seconds"] for row in rows if row["family"] == family and row["stage"] in stages]
    return [sum(seconds) for seconds in zip(*chosen)]


def panel(rows, title, stages, left, families, sizes):
    low, high = math.log2(sizes[0]), math.log2(sizes[-1])

    def x(size):
        return left + (math.log2(size) - low) / (high - low) * PANEL

    def y(seconds):
        seconds = min(max(seconds, LEAST), MOST)
        return TOP + HEIGHT * (1 - math.log(seconds / LEAST) / math.log(MOST / LEAST))

    yield f'<text x="{left}" y="{TOP - 10}">{title}</text>'
    for size in sizes:
        yield f'<line x1="{x(size):.1f}" y1="{TOP}" x2="{x(size):.1f}" y2="{TOP + HEIGHT}" stroke="#ddd"/>'
    for size in sizes[::2]:
        yield f'<text x="{x(size):.1f}" y="{TOP + HEIGHT + 18}" text-anchor="middle">{size // 1024}k</text>'
    for seconds in (0.01, 0.1, 1, 10):
        yield f'<line x1="{left}" y1="{y(seconds):.1f}" x2="{left + PANEL}" y2="{y(seconds):.1f}" stroke="#ddd"/>'
        if left == LEFT:
            yield f'<text x="{left - 8}" y="{y(seconds) + 4:.1f}" text-anchor="end">{seconds:g} s</text>'
    steepest = [0.1 * (size / sizes[0]) ** 1.2 for size in sizes]
    yield (f'<line x1="{x(sizes[0]):.1f}" y1="{y(steepest[0]):.1f}" x2="{x(sizes[-1]):.1f}" y2="{y(steepest[-1]):.1f}" '
           'stroke="#999" stroke-width="6" stroke-opacity="0.35"/>')
    for family, color in zip(families, COLORS):
        points = " ".join(f"{x(size):.1f},{y(t):.1f}" for size, t in zip(sizes, times(rows, family, stages)))
        yield f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="1.8"/>'


def drawn(rows):
    families = list(dict.fromkeys(row["family"] for row in rows))
    sizes = rows[0]["sizes"]
    yield f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {TOP + HEIGHT + 54}" font-family="sans-serif" font-size="13">'
    yield '<rect width="100%" height="100%" fill="white"/>'
    for place, (title, stages) in enumerate(STAGES.items()):
        yield from panel(rows, title, stages, LEFT + place * (PANEL + GAP), families, sizes)
    right = WIDTH - 108
    for place, (family, color) in enumerate(zip(families, COLORS)):
        height = TOP + 12 + 22 * place
        yield f'<line x1="{right}" y1="{height}" x2="{right + 20}" y2="{height}" stroke="{color}" stroke-width="2.5"/>'
        yield f'<text x="{right + 26}" y="{height + 4}">{family}</text>'
    height = TOP + 12 + 22 * len(families)
    yield f'<line x1="{right}" y1="{height}" x2="{right + 20}" y2="{height}" stroke="#999" stroke-width="6" stroke-opacity="0.35"/>'
    yield f'<text x="{right + 26}" y="{height + 4}">size^1.2</text>'
    yield f'<text x="{LEFT + 1.5 * PANEL + GAP}" y="{TOP + HEIGHT + 42}" text-anchor="middle">triangles or nodes</text>'
    yield "</svg>"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--from", dest="measured", type=pathlib.Path, help="what opaline_growth_bench --json has written")
    parser.add_argument("--into", type=pathlib.Path, default=pathlib.Path("."))
    arguments = parser.parse_args()
    rows = json.loads(arguments.measured.read_text()) if arguments.measured else measured()
    (arguments.into / "growth.svg").write_text("\n".join(drawn(rows)) + "\n")


if __name__ == "__main__":
    main()
