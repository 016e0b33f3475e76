"""Blender's world is z up, in its own units; ours is y up, in millimetres."""

import numpy as np

# Rows of the rotation from Blender's axes to ours, the same as in Blender's glTF exporter.
AXES = np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]], dtype=np.float64)


def mm_per_unit(scene):
    """Millimetres per unit of the scene. Without units, one is a metre."""
    settings = scene.unit_settings
    return 1000 * (settings.scale_length if settings.system != "NONE" else 1)


def turned(vectors):
    """Converts directions, or places in Blender's units, to our axes: (..., 3)."""
    return np.asarray(vectors, dtype=np.float64) @ AXES.T


def turned_back(vectors):
    """Converts from our axes to Blender's."""
    return np.asarray(vectors, dtype=np.float64) @ AXES
