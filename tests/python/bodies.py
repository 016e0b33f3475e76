"""Small bodies and a renderer of few pixels."""

import numpy as np

import opaline

FACES = np.array([(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)])
CORNERS = 10.0 * np.array([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)])


def octahedron(medium="marble"):
    return opaline.Object(CORNERS, FACES, medium=medium)


def scene(medium="marble"):
    made = opaline.Scene([octahedron(medium)])
    made.look_from((0.3, 0.4, 1))
    return made


def small(renderer, *aovs, **more):
    return renderer.render(24, 16, aovs or "position", **{"transport": "dipole", "max_surfels": 4096, **more})


_shared = []


def shared_renderer(scene):
    """One for all tests of a module, which compiles its shaders once; shows the scene."""
    if _shared:
        _shared[0].set_scene(scene)
    else:
        _shared.append(opaline.Renderer(scene))
    return _shared[0]
