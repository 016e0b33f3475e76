"""Blender's world is z up, in units of its own; ours is y up, in millimetres."""

import numpy as np

# Rows of the turn from Blender's axes to ours, which is the one that Blender's exporter of glTF makes.
AXES = np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]], dtype=np.float64)


def mm_per_unit(scene):
    """Of lengths in the scene. Where units are off, one is a metre."""
    settings = scene.unit_settings
    return 1000 * (settings.scale_length if settings.system != "NONE" else 1)


def turned(vectors):
    """Directions, or places in Blender's units, in our axes: (..., 3)."""
    return np.asarray(vectors, dtype=np.float64) @ AXES.T


def turned_back(vectors):
    """From our axes to Blender's."""
    return np.asarray(vectors, dtype=np.float64) @ AXES
