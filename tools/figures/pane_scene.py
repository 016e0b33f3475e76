#!/usr/bin/env python3
"""Writes pane.toml: a sheet of gummy-orange, 1 mm thick, on the ground before a bear of marble and a teapot that lets no
light through."""

import argparse
import math
import pathlib

EDGE, THICKNESS = 24.0, 1.0  # mm
QUADS = 48  # along an edge

SCENE = """# Written by pane_scene.py.
medium = "gummy-orange"

[[models]]
file = "pane.obj"
diagonal_mm = {diagonal:.6f}

[[models]]
file = "builtin:bear"
diagonal_mm = 24
translation_mm = [9, -2.55, -12]

[objects.bear]
medium = "marble"

[[models]]
file = "builtin:teapot"
diagonal_mm = 18
translation_mm = [-5, -11.5, -9]

[materials.plaster]
kind = "opaque"
base_color = [0.1, 0.25, 0.6]

[objects.teapot]
material = "plaster"

[ground]
color = [0.8, 0.8, 0.8]

[camera]
direction = [0.2, 0.25, 1]
target_mm = [2, -1.5, 0]
fov_degrees = 37

[[lights]]
type = "directional"
direction_to_light = [-0.6, 1, 0.3]
irradiance = [2, 2, 2]

[[lights]]
type = "ambient"
radiance = [0.3, 0.3, 0.35]
"""


def sheet():
    """Places and faces of a box whose large sides are divided."""
    along = [EDGE * (i / QUADS - 0.5) for i in range(QUADS + 1)]
    places = [(x, y, z) for z in (THICKNESS / 2, -THICKNESS / 2) for y in along for x in along]
    other = len(places) // 2
    at = lambda i, j: 1 + j * (QUADS + 1) + i
    quads = []
    for j in range(QUADS):
        for i in range(QUADS):
            front = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1))
            quads += [front, tuple(other + corner for corner in front[::-1])]
    for i in range(QUADS):
        for a, b in ((at(i + 1, 0), at(i, 0)), (at(i, QUADS), at(i + 1, QUADS)), (at(0, i), at(0, i + 1)),
                     (at(QUADS, i + 1), at(QUADS, i))):
            quads.append((a, b, other + b, other + a))
    return places, quads


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--into", type=pathlib.Path, default=pathlib.Path())
    into = parser.parse_args().into
    places, quads = sheet()
    (into / "pane.obj").write_text("s 0\n" + "".join("v {:.5f} {:.5f} {:.5f}\n".format(*place) for place in places) +
                                   "".join("f {} {} {} {}\n".format(*quad) for quad in quads))
    (into / "pane.toml").write_text(SCENE.format(diagonal=math.sqrt(2 * EDGE**2 + THICKNESS**2)))


if __name__ == "__main__":
    main()
