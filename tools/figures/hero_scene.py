#!/usr/bin/env python3
"""Writes hero.toml, the scene of the front page's picture: a scanned head with a gold hoop in its ear and a string of
beads around its neck, behind a stone parapet with a gummy bear on it, before the evening sun. Arguments are the head
and the sky."""

import argparse
import json
import math
import pathlib
import struct

# mm, in the head's own coordinates.
EAR_LOBE = (68.0, 234.0, 20.5)
HOOP_RADIUS, HOOP_WIRE = 15.0, 1.3
# The beads lie in a plane that slopes forward.
NAPE_HEIGHT, FALL = 112.0, -0.5
BEAD_RADIUS, BEAD_GAP = 4.6, 0.35
GOLD_EVERY = 6
# In front of the scan's lower end.
PARAPET_LOW, PARAPET_HIGH, PARAPET_EDGE = (-700.0, -60.0, 165.0), (700.0, 62.0, 340.0), 4.0
# Beads left over from the string, on the parapet.
LOOSE_BEADS = [(128, 290), (146, 262), (110, 302), (205, 312)]
BEAR = (215.0, 62.0, 250.0)
BEAR_DIAGONAL = 78.0

CAMERA, TARGET = (330, 250, 1000), (55, 178, 0)
TURN = 34
FILL = [3, 2.7, 2.45]

MATERIALS = {
    "gold": "Kd 0.98 0.74 0.36\nPm 1\nPr 0.24\n",
    "turquoise": "Kd 0.07 0.34 0.36\nPm 0\nPr 0.22\n",
    "stone": "Kd 0.42 0.37 0.31\nPm 0\nPr 0.85\n",
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

[[models]]
file = "parapet.obj"
diagonal_mm = {parapet}

[[models]]
file = "builtin:bear"
diagonal_mm = {bear_diagonal}
medium = "gummy-red"
rotation_degrees = [0, -12, 0]
translation_mm = {bear}

[environment]
file = "{sky}"
rotation_degrees = {turn}

# A photographer's lamp.
[[lights]]
type = "directional"
direction_to_light = [-0.62, 0.5, 0.6]
irradiance = {fill}

[camera]
position_mm = {camera}
target_mm = {target}
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
    """The convex hull of places in a plane, counter-clockwise (Andrew 1979)."""
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
    """Places along a closed line, spaced as near to the wanted distance as fits."""
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


def flat_normal(corners):
    (ax, ay, az), (bx, by, bz) = ([q - p for p, q in zip(corners[0], corner)] for corner in (corners[1], corners[2]))
    normal = (ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
    return [x / math.hypot(*normal) for x in normal]


class Mesh:
    def __init__(self):
        self.places, self.faces, self.material = [], [], None
        self.is_flat = False

    def grid(self, rows, columns, place):
        """Adds a surface that closes in both directions."""
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
        """Writes the mesh and returns the diagonal of its box."""
        # Flat faces do not share corners, so that each has its own normal.
        if self.is_flat:
            self.places = [self.places[corner - 1] for _, corners in self.faces for corner in corners]
            self.faces = [(its, range(4 * i + 1, 4 * i + 5)) for i, (its, _) in enumerate(self.faces)]
        lines = [f"mtllib {path.stem}.mtl"] + ["v " + " ".join(f"{x:.4f}" for x in place) for place in self.places]
        material = None
        for its, corners in self.faces:
            if its != material:
                material = its
                lines.append(f"usemtl {material}")
            if self.is_flat:
                normal = flat_normal([self.places[corner - 1] for corner in corners])
                lines.append("vn " + " ".join(f"{x:.6f}" for x in normal))
                lines.append("f " + " ".join(f"{corner}//-1" for corner in corners))
            else:
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
        # Slightly out of the plane in which it would hang.
        return (middle[0] + HOOP_WIRE * math.sin(roll) - 0.35 * radius * math.sin(turn), middle[1] + radius * math.cos(turn),
                middle[2] + radius * math.sin(turn))
    mesh.grid(96, 16, place)
    return mesh


def beads(corners):
    mesh = Mesh()
    near = [(x, z) for x, y, z in corners if abs(y - (NAPE_HEIGHT + FALL * z)) < 4]
    line = hull(near)
    middle = [sum(axis) / len(line) for axis in zip(*line)]
    # The string lies outside the skin.
    line = [tuple(m + (p - m) * (1 + (BEAD_RADIUS + 0.5) / math.dist((x, z), middle)) for m, p in zip(middle, (x, z)))
            for x, z in line]
    for i, (x, z) in enumerate(around(line, 2 * BEAD_RADIUS + BEAD_GAP)):
        mesh.material = "gold" if i % GOLD_EVERY == 0 else "turquoise"
        radius = BEAD_RADIUS * (0.8 if mesh.material == "gold" else 1)
        mesh.ball((x, NAPE_HEIGHT + FALL * z + BEAD_RADIUS, z), radius)
    for i, (x, z) in enumerate(LOOSE_BEADS):
        mesh.material = "gold" if i == 1 else "turquoise"
        mesh.ball((x, PARAPET_HIGH[1] + BEAD_RADIUS, z), BEAD_RADIUS)
    mesh.faces.sort(key=lambda face: face[0])
    return mesh


def parapet():
    """A slab with bevelled edges, which catch the light."""
    mesh = Mesh()
    mesh.material, mesh.is_flat = "stone", True
    low, high, edge = PARAPET_LOW, PARAPET_HIGH, PARAPET_EDGE
    rings = [(low[1], 0.0), (high[1] - edge, 0.0), (high[1], edge)]
    for height, within in rings:
        mesh.places += [(low[0] + within, height, high[2] - within), (high[0] - within, height, high[2] - within),
                        (high[0] - within, height, low[2] + within), (low[0] + within, height, low[2] + within)]
    for ring in (1, 5):
        for k in range(4):
            following = (k + 1) % 4
            mesh.faces.append((mesh.material, [ring + k, ring + following, ring + 4 + following, ring + 4 + k]))
    mesh.faces.append((mesh.material, [9, 10, 11, 12]))
    mesh.faces.append((mesh.material, [4, 3, 2, 1]))
    return mesh


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("head", type=pathlib.Path)
    parser.add_argument("sky", type=pathlib.Path)
    parser.add_argument("--into", type=pathlib.Path, default=pathlib.Path())
    parser.add_argument("--turn", type=float, default=TURN, help="of the sky, degrees")
    arguments = parser.parse_args()
    into = arguments.into
    # Places are relative to the middle of the box around everything, which spans from the parapet to the crown.
    corners = triangle_corners(arguments.head)
    middle = [0.5 * (PARAPET_LOW[0] + PARAPET_HIGH[0]), 0.5 * (PARAPET_LOW[1] + max(y for _, y, _ in corners)),
              0.5 * (min(z for *_, z in corners) + PARAPET_HIGH[2])]
    text = SCENE.format(head=arguments.head.resolve(), sky=arguments.sky.resolve(), turn=arguments.turn, fill=FILL,
                        bear_diagonal=BEAR_DIAGONAL, bear=list(BEAR),
                        camera=[round(p - m, 3) for p, m in zip(CAMERA, middle)],
                        target=[round(p - m, 3) for p, m in zip(TARGET, middle)],
                        hoop=hoop().write(into / "hoop.obj"), beads=beads(corners).write(into / "beads.obj"),
                        parapet=parapet().write(into / "parapet.obj"))
    (into / "hero.toml").write_text(text)


if __name__ == "__main__":
    main()
