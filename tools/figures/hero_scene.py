#!/usr/bin/env python3
"""Writes hero.toml, the scene of the front page's picture: a scanned head at sunset that turns, with a hoop of gold in its ear
and a string of beads that is laid around its neck. Arguments are the head and the sky."""

import argparse
import json
import math
import pathlib
import struct

# mm, in the head's own coordinates.
EAR_LOBE = (68.0, 234.0, 20.5)
HOOP_RADIUS, HOOP_WIRE = 15.0, 1.3
# The beads lie in a plane that falls forward.
NAPE_HEIGHT, FALL = 112.0, -0.5
BEAD_RADIUS, BEAD_GAP = 4.6, 0.35
GOLD_EVERY = 6

MATERIALS = {
    "gold": "Kd 0.98 0.74 0.36\nPm 1\nPr 0.24\n",
    "turquoise": "Kd 0.07 0.34 0.36\nPm 0\nPr 0.22\n",
}

SCENE = """# Written by hero_scene.py.
[[models]]
file = "{head}"

[[models]]
file = "hoop.obj"
diagonal_mm = {hoop}

[[models]]
file = "beads.obj"
diagonal_mm = {beads}

[environment]
file = "{sky}"
rotation_degrees = {turn}

[[deform]]
kind = "twist"
amount = {twist}

[camera]
position_mm = [330, 150, 660]
target_mm = [4, 52, 0]
fov_degrees = 25
"""


def triangle_corners(glb):
    """Positions of a GLB's only mesh, mm."""
    data = glb.read_bytes()
    length, = struct.unpack_from("<I", data, 12)
    model = json.loads(data[20:20 + length])
    binary = data[28 + length:]
    accessor = model["accessors"][model["meshes"][0]["primitives"][0]["attributes"]["POSITION"]]
    view = model["bufferViews"][accessor["bufferView"]]
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    stride = view.get("byteStride", 12)
    return [tuple(1000 * value for value in struct.unpack_from("<3f", binary, start + i * stride))
            for i in range(accessor["count"])]


def hull(points):
    """Of places in a plane, counter-clockwise (Andrew 1979)."""
    def half(ordered):
        chain = []
        for p in ordered:
            while len(chain) > 1 and ((chain[-1][0] - chain[-2][0]) * (p[1] - chain[-2][1]) -
                                      (chain[-1][1] - chain[-2][1]) * (p[0] - chain[-2][0])) <= 0:
                chain.pop()
            chain.append(p)
        return chain[:-1]
    ordered = sorted(set(points))
    return half(ordered) + half(ordered[::-1])


def around(outline, step):
    """Places along a closed line, as near to so far apart as fits."""
    edges = [(a, b, math.dist(a, b)) for a, b in zip(outline, outline[1:] + outline[:1])]
    whole = sum(length for *_, length in edges)
    count = round(whole / step)
    places, edge, before = [], 0, 0.0
    for i in range(count):
        at = i * whole / count
        while before + edges[edge][2] < at:
            before += edges[edge][2]
            edge += 1
        a, b, length = edges[edge]
        part = (at - before) / length
        places.append(tuple(p + part * (q - p) for p, q in zip(a, b)))
    return places


class Mesh:
    def __init__(self):
        self.places, self.faces, self.material = [], [], None

    def grid(self, rows, columns, place):
        """A surface that closes in both directions."""
        first = len(self.places) + 1
        self.places += [place(i / rows, j / columns) for i in range(rows) for j in range(columns)]
        for i in range(rows):
            for j in range(columns):
                corners = [first + (i + di) % rows * columns + (j + dj) % columns for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1))]
                self.faces.append((self.material, corners))

    def ball(self, centre, radius, rows=14, columns=24):
        first = len(self.places) + 1
        for i in range(1, rows):
            polar = math.pi * i / rows
            for j in range(columns):
                turn = 2 * math.pi * j / columns
                offset = (math.sin(polar) * math.cos(turn), math.cos(polar), -math.sin(polar) * math.sin(turn))
                self.places.append(tuple(c + radius * o for c, o in zip(centre, offset)))
        self.places += [(centre[0], centre[1] + radius, centre[2]), (centre[0], centre[1] - radius, centre[2])]
        top, bottom = len(self.places) - 1, len(self.places)
        for j in range(columns):
            following = (j + 1) % columns
            self.faces.append((self.material, [top, first + j, first + following]))
            low = first + (rows - 2) * columns
            self.faces.append((self.material, [bottom, low + following, low + j]))
            for i in range(rows - 2):
                a, b = first + i * columns, first + (i + 1) * columns
                self.faces.append((self.material, [a + j, b + j, b + following, a + following]))

    def write(self, path):
        """Returns the diagonal of its box."""
        lines = [f"mtllib {path.stem}.mtl"] + ["v " + " ".join(f"{x:.4f}" for x in place) for place in self.places]
        material = None
        for its, corners in self.faces:
            if its != material:
                material = its
                lines.append(f"usemtl {material}")
            lines.append("f " + " ".join(map(str, corners)))
        path.write_text("\n".join(lines) + "\n")
        path.with_suffix(".mtl").write_text("".join(f"newmtl {name}\n{text}" for name, text in MATERIALS.items()))
        rounded = [[float(f"{x:.4f}") for x in place] for place in self.places]
        return math.dist([min(axis) for axis in zip(*rounded)], [max(axis) for axis in zip(*rounded)])


def hoop():
    mesh = Mesh()
    mesh.material = "gold"
    middle = (EAR_LOBE[0] + HOOP_WIRE, EAR_LOBE[1] - HOOP_RADIUS, EAR_LOBE[2])

    def place(along, across):
        turn, roll = 2 * math.pi * along, 2 * math.pi * across
        radius = HOOP_RADIUS + HOOP_WIRE * math.cos(roll)
        # A little out of the plane that it would hang in.
        return (middle[0] + HOOP_WIRE * math.sin(roll) - 0.35 * radius * math.sin(turn), middle[1] + radius * math.cos(turn),
                middle[2] + radius * math.sin(turn))
    mesh.grid(96, 16, place)
    return mesh


def beads(corners):
    mesh = Mesh()
    near = [(x, z) for x, y, z in corners if abs(y - (NAPE_HEIGHT + FALL * z)) < 4]
    line = hull(near)
    middle = [sum(axis) / len(line) for axis in zip(*line)]
    # Outside of the skin.
    line = [tuple(m + (p - m) * (1 + (BEAD_RADIUS + 0.5) / math.dist((x, z), middle)) for m, p in zip(middle, (x, z)))
            for x, z in line]
    for i, (x, z) in enumerate(around(line, 2 * BEAD_RADIUS + BEAD_GAP)):
        mesh.material = "gold" if i % GOLD_EVERY == 0 else "turquoise"
        radius = BEAD_RADIUS * (0.8 if mesh.material == "gold" else 1)
        mesh.ball((x, NAPE_HEIGHT + FALL * z + BEAD_RADIUS, z), radius)
    mesh.faces.sort(key=lambda face: face[0])
    return mesh


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("head", type=pathlib.Path)
    parser.add_argument("sky", type=pathlib.Path)
    parser.add_argument("--into", type=pathlib.Path, default=pathlib.Path())
    parser.add_argument("--turn", type=float, default=0.0)
    parser.add_argument("--twist", type=float, default=0.0)
    arguments = parser.parse_args()
    into = arguments.into
    text = SCENE.format(head=arguments.head.resolve(), sky=arguments.sky.resolve(), turn=arguments.turn, twist=arguments.twist,
                        hoop=hoop().write(into / "hoop.obj"),
                        beads=beads(triangle_corners(arguments.head)).write(into / "beads.obj"))
    (into / "hero.toml").write_text(text)


if __name__ == "__main__":
    main()
