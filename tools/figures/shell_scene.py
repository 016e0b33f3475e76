#!/usr/bin/env python3
"""Writes shell.toml and lantern.toml: a hollow ball of gummy-orange on the ground beside a bear that lets no light
through, under a spot light, and with a point light inside."""

import argparse
import math
import pathlib

RADIUS, WALL = 10.0, 0.7  # mm
ROWS, COLUMNS = 96, 192

SCENE = """# Written by shell_scene.py.
medium = "gummy-orange"

[[models]]
file = "shell.obj"
diagonal_mm = {diagonal}

[[models]]
file = "builtin:bear"
diagonal_mm = 12
translation_mm = [15, -11, 7]

[materials.plaster]
kind = "opaque"
base_color = [0.7, 0.7, 0.7]

[objects.bear]
material = "plaster"

[ground]
color = [0.8, 0.8, 0.8]

[camera]
direction = [0.15, 0.6, 1]
target_mm = [0, -3, 0]
fov_degrees = 37

"""

SPOT = """[[lights]]
type = "spot"
position_mm = [-20, 70, 30]
direction = [0.25, -1, -0.35]
intensity = [20000, 20000, 20000]
inner_degrees = 10
outer_degrees = 30
"""

POINT = """[[lights]]
type = "point"
position_mm = [0, -4, 0]
intensity = [600, 600, 600]
"""


def ball(radius):
    """Rows of places from pole to pole."""
    return [(radius * math.sin(math.pi * i / ROWS) * math.sin(2 * math.pi * j / COLUMNS), radius * math.cos(math.pi * i / ROWS),
             radius * math.sin(math.pi * i / ROWS) * math.cos(2 * math.pi * j / COLUMNS))
            for i in range(1, ROWS) for j in range(COLUMNS)] + [(0, radius, 0), (0, -radius, 0)]


def faces(first, inwards):
    top, bottom = first + (ROWS - 1) * COLUMNS, first + (ROWS - 1) * COLUMNS + 1
    at = lambda i, j: first + i * COLUMNS + j % COLUMNS
    found = [(top, at(0, j), at(0, j + 1)) for j in range(COLUMNS)]
    found += [(bottom, at(ROWS - 2, j + 1), at(ROWS - 2, j)) for j in range(COLUMNS)]
    for i in range(ROWS - 2):
        for j in range(COLUMNS):
            found += [(at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1))]
    return [face[::-1] for face in found] if inwards else found


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--into", type=pathlib.Path, default=pathlib.Path())
    into = parser.parse_args().into
    places = ball(RADIUS) + ball(RADIUS - WALL)
    both = faces(1, False) + faces(1 + len(places) // 2, True)
    (into / "shell.obj").write_text("".join("v {:.5f} {:.5f} {:.5f}\n".format(*place) for place in places) +
                                    "".join("f {} {} {}\n".format(*face) for face in both))
    scene = SCENE.format(diagonal=2 * RADIUS * math.sqrt(3))
    for name, light in (("shell", SPOT), ("lantern", POINT)):
        (into / f"{name}.toml").write_text(scene + light)


if __name__ == "__main__":
    main()
