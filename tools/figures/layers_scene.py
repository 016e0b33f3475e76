#!/usr/bin/env python3
"""Writes layers.toml: a sweet of three layers, lit from behind. The layers are one body of three media."""

import argparse
import math
import pathlib

RADIUS, HEIGHT = 17.0, 21.0  # mm: radius and half height
ROUND = 3.2  # exponent of the outline: 2 is an ellipse
TILT = 24  # degrees
COLUMNS, ROWS = 128, 96
LAYERS = [("raspberry", -1.0), ("cream", -0.3), ("lemon", 0.28)]  # each starts at that share of the half height

SCENE = """# Written by layers_scene.py.
[media.raspberry]
sigma_s_per_mm = [0.9, 0.8, 0.8]
sigma_a_per_mm = [0.006, 0.16, 0.09]
eta = 1.35

[media.cream]
sigma_s_per_mm = [2.4, 2.5, 2.6]
sigma_a_per_mm = [0.001, 0.002, 0.006]
eta = 1.35

[media.lemon]
sigma_s_per_mm = [0.5, 0.5, 0.5]
sigma_a_per_mm = [0.004, 0.009, 0.09]
eta = 1.35

[[lights]]
type = "directional"
direction_to_light = [-0.5, 0.45, -0.75]
irradiance = [5, 4.8, 4.6]

[[lights]]
type = "directional"
direction_to_light = [0.6, 0.5, 0.62]
irradiance = [1.3, 1.35, 1.45]

[[lights]]
type = "ambient"
radiance = [0.08, 0.09, 0.11]

[camera]
position_mm = [0, 34, 150]
target_mm = [0, 0, 0]
fov_degrees = 18

[[models]]
file = "layers.obj"
diagonal_mm = {diagonal}
rotation_degrees = [0, 0, {tilt}]
"""

OBJECT = """
[objects."{name}"]
medium = "{name}"
"""


def outline(row):
    """Distance from the axis and height of a row of the outline, from bottom to top."""
    angle = math.pi * row / ROWS
    across, up = math.sin(angle), -math.cos(angle)
    size = (abs(across) ** ROUND + abs(up) ** ROUND) ** (-1 / ROUND)
    return RADIUS * across * size, HEIGHT * up * size


def layer_of(corners):
    share = sum(y for _, y, _ in corners) / len(corners) / HEIGHT
    return max(i for i, (_, begin) in enumerate(LAYERS) if share >= begin or i == 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--into", type=pathlib.Path, default=pathlib.Path())
    into = parser.parse_args().into
    rings = [outline(row) for row in range(1, ROWS)]
    places = [(r * math.sin(2 * math.pi * j / COLUMNS), y, r * math.cos(2 * math.pi * j / COLUMNS)) for r, y in rings for j in range(COLUMNS)]
    bottom, top = len(places), len(places) + 1
    places += [(0, -HEIGHT, 0), (0, HEIGHT, 0)]
    around = [(j, (j + 1) % COLUMNS) for j in range(COLUMNS)]
    last = (ROWS - 2) * COLUMNS
    faces = [(bottom, b, a) for a, b in around] + [(top, last + a, last + b) for a, b in around]
    faces += [(i * COLUMNS + a, i * COLUMNS + b, (i + 1) * COLUMNS + b, (i + 1) * COLUMNS + a) for i in range(ROWS - 2) for a, b in around]
    text = "mtllib layers.mtl\n" + "".join("v {:.5f} {:.5f} {:.5f}\n".format(*place) for place in places)
    for i, (name, _) in enumerate(LAYERS):
        text += f"usemtl {name}\n"
        text += "".join("f " + " ".join(str(corner + 1) for corner in face) + "\n"
                        for face in faces if layer_of([places[corner] for corner in face]) == i)
    (into / "layers.obj").write_text(text)
    (into / "layers.mtl").write_text("".join(f"newmtl {name}\nKd 0.8 0.8 0.8\n" for name, _ in LAYERS))
    diagonal = math.dist([min(axis) for axis in zip(*places)], [max(axis) for axis in zip(*places)])
    (into / "layers.toml").write_text(SCENE.format(diagonal=diagonal, tilt=TILT) + "".join(OBJECT.format(name=name) for name, _ in LAYERS))


if __name__ == "__main__":
    main()
