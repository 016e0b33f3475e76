"""Pixels that are not square: pictures are rendered with finer square pixels and converted."""

import numpy as np


def square_size(width, height, projection):
    """The size in square pixels of what a projection shows; neither edge is less than asked for."""
    aspect = projection[1, 1] / projection[0, 0]
    if aspect * height > width:
        return max(round(aspect * height), width), height
    return width, max(round(width / aspect), height)


def averaged(picture, width, height):
    """Each pixel is the mean over its area."""
    for axis, count in enumerate((height, width)):
        if picture.shape[axis] != count:
            picture = np.moveaxis(_averaged(np.moveaxis(picture, axis, 0), count), 0, axis)
    return picture


def _averaged(rows, count):
    """Sums the rows before each edge, including a part of the row that the edge divides."""
    sums = np.concatenate([np.zeros((1, *rows.shape[1:])), np.cumsum(rows, axis=0, dtype=np.float64)])
    edges = np.arange(count + 1) * len(rows) / count
    whole = np.minimum(edges.astype(int), len(rows) - 1)
    before = sums[whole] + (edges - whole)[:, None, None] * rows[whole]
    return (np.diff(before, axis=0) * count / len(rows)).astype(rows.dtype)


def nearest(picture, width, height):
    """Each pixel is the value at its middle."""
    rows, columns = (((np.arange(count) + 0.5) * have / count).astype(int) for count, have in zip((height, width), picture.shape))
    return picture[rows[:, None], columns]
