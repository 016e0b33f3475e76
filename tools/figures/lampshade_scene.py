#!/usr/bin/env python3
"""Writes lampshade.toml: a lamp with a pleated paper shade, and a small bear of milk beside its foot."""

import argparse
import math
import pathlib

# In mm. The shade is wider and higher than all else, so that the middle of everything lies on its axis.
SHADE = [(92.0, 74.0), (190.0, 40.0)]  # height, radius
PLEATS, DEPTH = 40, 0.035
FOOT = [(0, 0), (0, 40), (1, 43), (3, 44), (5, 43), (7, 40), (10, 30), (14, 19), (19, 11), (26, 6), (60, 4.5), (114, 3.5), (118, 0)]
MIDDLE = 0.5 * SHADE[1][0]
LAMP = 150.0

SCENE = """# Written by lampshade_scene.py.
[[models]]
file = "shade.obj"
diagonal_mm = {shade}

[[models]]
file = "foot.obj"
diagonal_mm = {foot}

[[models]]
file = "builtin:bear"
diagonal_mm = 64
medium = "wholemilk"
rotation_degrees = [0, 12, 0]
translation_mm = [56, 0, 30]

[materials.paper]
kind = "opaque"
base_color = [0.86, 0.8, 0.68]
roughness = 0.9
specular = 0.3
diffuse_transmission = 0.55
diffuse_transmission_color = [0.95, 0.74, 0.42]

[materials.glaze]
kind = "opaque"
base_color = [0.12, 0.3, 0.32]
roughness = 0.35

[objects.shade]
material = "paper"

[objects.foot]
material = "glaze"

[ground]
color = [0.42, 0.28, 0.18]

[[lights]]
type = "point"
position_mm = [0, {lamp}, 0]
intensity = [26000, 20500, 14000]

[[lights]]
type = "ambient"
radiance = [0.03, 0.04, 0.06]

[camera]
position_mm = [150, 130, 560]
target_mm = [8, 2, 0]
fov_degrees = 22
"""


def write(path, profile, columns, pleat):
    """Writes a surface of revolution and returns the diagonal of its box."""
    places = [(r * pleat(j) * math.sin(2 * math.pi * j / columns), h, r * pleat(j) * math.cos(2 * math.pi * j / columns))
              for h, r in profile for j in range(columns)]
    faces = [(i * columns + j, i * columns + (j + 1) % columns, (i + 1) * columns + (j + 1) % columns, (i + 1) * columns + j)
             for i in range(len(profile) - 1) for j in range(columns)]
    path.write_text("".join("v {:.4f} {:.4f} {:.4f}\n".format(*place) for place in places) +
                    "".join("f " + " ".join(str(corner + 1) for corner in face) + "\n" for face in faces))
    return math.dist([min(axis) for axis in zip(*places)], [max(axis) for axis in zip(*places)])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--into", type=pathlib.Path, default=pathlib.Path())
    into = parser.parse_args().into
    (low, wide), (high, narrow) = SHADE
    rows = 12
    shade = [(low + i / rows * (high - low), wide + i / rows * (narrow - wide)) for i in range(rows + 1)]
    text = SCENE.format(shade=write(into / "shade.obj", shade, 8 * PLEATS, lambda j: 1 + DEPTH * math.cos(math.pi * j / 4)),
                        foot=write(into / "foot.obj", FOOT, 64, lambda j: 1.0), lamp=LAMP - MIDDLE)
    (into / "lampshade.toml").write_text(text)


if __name__ == "__main__":
    main()
