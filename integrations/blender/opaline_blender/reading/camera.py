"""Cameras, from the matrices with which Blender projects."""

import itertools
import math

import numpy as np

from .. import units


def _before(place, ahead, bounds):
    """How far back, in mm, the camera must be so that nothing in the bounds is behind it."""
    low, high = bounds
    nearest = np.where(ahead > 0, low, high)
    return 1.01 * max(float(np.dot(place - nearest, ahead)), 0)


def camera_of(to_world, projection, mm_per_unit, bounds=None):
    """opaline.Camera from the camera's matrix and its projection, in OpenGL's convention: looking along -z, y up.

    The near plane of a parallel projection may lie behind its place, as in viewports. Objects there are shown if the
    bounds of everything are given, in our axes and mm."""
    import opaline

    matrix, projection = np.array(to_world, dtype=float), np.array(projection, dtype=float)
    place = units.turned(matrix[:3, 3]) * mm_per_unit
    ahead = units.turned(-matrix[:3, 2] / np.linalg.norm(matrix[:3, 2]))
    up = units.turned(matrix[:3, 1] / np.linalg.norm(matrix[:3, 1]))
    target = place + ahead * max(100.0, float(np.abs(place).max()) * 0.1)
    if projection[3, 3] == 1:
        near = (1 + projection[2, 3]) / projection[2, 2] * mm_per_unit
        if near < 0 and bounds is not None:
            place, target = (point - ahead * min(-near, _before(place, ahead, bounds)) for point in (place, target))
        return opaline.Camera(place, target, up, shift_x=-projection[0, 3] / 2, shift_y=-projection[1, 3] / 2,
                              orthographic_height_mm=2 / projection[1, 1] * mm_per_unit)
    fov = math.degrees(2 * math.atan(1 / projection[1, 1]))
    return opaline.Camera(place, target, up, min(max(fov, 1), 170), shift_x=projection[0, 2] / 2, shift_y=projection[1, 2] / 2)


def clips(to_world, projection, mm_per_unit, mesh):
    """Whether only the clip distances hide some of a mesh, in our axes and mm, from the picture."""
    to_picture = np.array(projection, dtype=float) @ np.linalg.inv(np.array(to_world, dtype=float))

    def projected(positions):
        places = units.turned_back(positions) / mm_per_unit
        return to_picture[:, :3] @ places.T + to_picture[:, 3:]

    _, _, z, w = projected(np.array(list(itertools.product(*zip(*mesh.bounds)))))
    if np.all((w > 0) & (np.abs(z) <= w)):  # then everything in the box is, too
        return False
    x, y, z, w = projected(mesh.positions)
    return bool(np.any((w > 0) & (np.abs(x) <= w) & (np.abs(y) <= w) & (np.abs(z) > w)))


def cropped(projection, left, bottom, right, top):
    """The projection of a part of the picture, given by its edges as shares of width and height."""
    width, height = right - left, top - bottom
    window = np.array([[1 / width, 0, 0, (1 - right - left) / width],
                       [0, 1 / height, 0, (1 - top - bottom) / height],
                       [0, 0, 1, 0], [0, 0, 0, 1]])
    return window @ np.array(projection, dtype=float)


def projection_of(camera_object, depsgraph, width, height, aspect_x, aspect_y):
    return np.array(camera_object.calc_matrix_camera(depsgraph, x=width, y=height, scale_x=aspect_x, scale_y=aspect_y))
