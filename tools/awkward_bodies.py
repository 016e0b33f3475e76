"""Ten bodies unlike any scan, to test the renderer with: flat, thin, coarse, hollow, sharp, inside out, overlapping and
numerous. Each is a list of vertices and a list of triangles, counter-clockwise as seen from outside."""

import math


def quad(edge=1.0):
    """One open square of two triangles, facing up."""
    h = edge / 2
    return [(-h, 0, -h), (-h, 0, h), (h, 0, h), (h, 0, -h)], [(0, 1, 2), (0, 2, 3)]


def box(x, y, z):
    """A box of twelve triangles."""
    corners = [(i * x / 2, j * y / 2, k * z / 2) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, [t for a, b, c, d in faces for t in ((a, b, c), (a, c, d))]


def revolved(profile, segments):
    """A surface of revolution about y. Its profile of (radius, height) runs along the outside from the bottom to the
    axis."""
    vertices, rings = [], []
    for radius, height in profile:
        if radius == 0:
            rings.append([len(vertices)] * segments)
            vertices.append((0.0, height, 0.0))
            continue
        rings.append(list(range(len(vertices), len(vertices) + segments)))
        vertices += [(radius * math.sin(2 * math.pi * s / segments), height, radius * math.cos(2 * math.pi * s / segments))
                     for s in range(segments)]
    triangles = []
    for low, high in zip(rings, rings[1:]):
        for s in range(segments):
            n = (s + 1) % segments
            if low[s] != low[n]:
                triangles.append((low[s], low[n], high[n]))
            if high[s] != high[n]:
                triangles.append((low[s], high[n], high[s]))
    return vertices, triangles


def sphere(radius, segments, rings):
    angles = [math.pi * (i / rings - .5) for i in range(rings + 1)]
    profile = [(0 if i in (0, rings) else radius * math.cos(a), radius * math.sin(a)) for i, a in enumerate(angles)]
    return revolved(profile, segments)


def joined(*bodies):
    vertices, triangles = [], []
    for points, faces in bodies:
        triangles += [tuple(i + len(vertices) for i in face) for face in faces]
        vertices += points
    return vertices, triangles


def moved(body, x, y, z):
    return [(a + x, b + y, c + z) for a, b, c in body[0]], body[1]


def turned_inside_out(body):
    return body[0], [(a, c, b) for a, b, c in body[1]]


def bowl():
    outer = [(math.sin(a), -math.cos(a)) for a in (math.pi / 2 * i / 12 for i in range(13))]
    inner = [(.9 * r, .9 * h) for r, h in reversed(outer)]
    return revolved([(0, -1)] + outer[1:] + inner[:-1] + [(0, -.9)], 40)


def star():
    """A sphere with alternating radii: sharp spikes of few triangles."""
    vertices, triangles = sphere(1, 20, 10)
    return [tuple(c * (1 if (i % 2) else .35) for c in v) for i, v in enumerate(vertices)], triangles


BODIES = {
    "quad": quad(),
    "cube": box(1, 1, 1),
    "plate": box(1, .01, 1),
    "rod": box(.02, 1, .02),
    "coarse_ball": sphere(.5, 6, 4),
    "bowl": bowl(),
    "star": star(),
    "overlapping": joined(sphere(.5, 24, 12), moved(sphere(.5, 24, 12), .5, .2, 0), moved(box(.3, 1.5, .3), .2, 0, 0)),
    "inside_out": turned_inside_out(sphere(.5, 32, 16)),
    "crumbs": joined(*(moved(sphere(.08, 8, 6), .2 * (i % 5), .2 * (i // 5 % 5), .2 * (i // 25)) for i in range(75))),
}


def write_obj(path, body):
    vertices, triangles = body
    path.write_text("".join(f"v {x:.7g} {y:.7g} {z:.7g}\n" for x, y, z in vertices)
                    + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in triangles))
