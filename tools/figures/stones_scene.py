#!/usr/bin/env python3
"""Writes stones.toml: three berries of jelly lit from behind. The second has a dark stone, the third a white one."""

import argparse
import math
import pathlib

# mm
BERRY, STONE = (10.0, 11.5), (4.2, 7.0)  # radius across, half the height
APART = 26.0
TILT = 24

SCENE = """# Written by stones_scene.py.
[media.jelly]
sigma_s_per_mm = [0.24, 0.26, 0.22]
sigma_a_per_mm = [0.012, 0.005, 0.06]
eta = 1.35

[[lights]]
type = "directional"
direction_to_light = [-0.12, 0.35, -0.93]
irradiance = [7, 6.6, 6]

[[lights]]
type = "directional"
direction_to_light = [0.5, 0.4, 0.77]
irradiance = [0.35, 0.4, 0.5]

[[lights]]
type = "ambient"
radiance = [0.05, 0.06, 0.08]

[camera]
position_mm = [0, 14, 128]
target_mm = [0, 0, 0]
fov_degrees = 15
"""

BODY = """
[[models]]
file = "{file}.obj"
diagonal_mm = {diagonal}
translation_mm = [{x}, 0, 0]
rotation_degrees = [0, 0, {tilt}]
"""

STONES = """
[materials.dark]
kind = "opaque"
base_color = [0.08, 0.05, 0.03]
roughness = 0.8

[materials.white]
kind = "opaque"
base_color = 0.95
roughness = 0.8

[objects.dark_stone]
material = "dark"

[objects.white_stone]
material = "white"
"""


def write(path, radius, height, columns, rows):
    """Writes a closed ellipsoid of revolution about y, and returns the diagonal of its box."""
    rings = [(radius * math.sin(math.pi * i / rows), -height * math.cos(math.pi * i / rows)) for i in range(1, rows)]
    places = [(r * math.sin(2 * math.pi * j / columns), y, r * math.cos(2 * math.pi * j / columns)) for r, y in rings for j in range(columns)]
    bottom, top = len(places), len(places) + 1
    places += [(0, -height, 0), (0, height, 0)]
    around = [(j, (j + 1) % columns) for j in range(columns)]
    last = (rows - 2) * columns
    faces = [(bottom, b, a) for a, b in around] + [(top, last + a, last + b) for a, b in around]
    faces += [(i * columns + a, i * columns + b, (i + 1) * columns + b, (i + 1) * columns + a) for i in range(rows - 2) for a, b in around]
    path.write_text("".join("v {:.4f} {:.4f} {:.4f}\n".format(*place) for place in places) +
                    "".join("f " + " ".join(str(corner + 1) for corner in face) + "\n" for face in faces))
    return math.dist([min(axis) for axis in zip(*places)], [max(axis) for axis in zip(*places)])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--into", type=pathlib.Path, default=pathlib.Path())
    into = parser.parse_args().into
    bodies = [("berry", BERRY, -APART), ("berry", BERRY, 0), ("berry", BERRY, APART), ("dark_stone", STONE, 0), ("white_stone", STONE, APART)]
    text = SCENE
    for name, size, x in bodies:
        diagonal = write(into / f"{name}.obj", *size, *((96, 48) if size is BERRY else (48, 24)))
        text += BODY.format(file=name, diagonal=diagonal, x=x, tilt=TILT) + ("medium = \"jelly\"\n" if size is BERRY else "")
    (into / "stones.toml").write_text(text + STONES)


if __name__ == "__main__":
    main()
