"""Pixels that are not square: pictures are rendered of square ones, which are finer along one side, and made of these."""

import numpy as np


def square_size(width, height, projection):
    """Width and height in square pixels of what a projection shows, neither of them less than what is asked for."""
    aspect = projection[1, 1] / projection[0, 0]
    if aspect * height > width:
        return max(round(aspect * height), width), height
    return width, max(round(width / aspect), height)


def averaged(picture, width, height):
    """Each pixel is the mean of what it covers."""
    for axis, count in enumerate((height, width)):
        if picture.shape[axis] != count:
            picture = np.moveaxis(_averaged(np.moveaxis(picture, axis, 0), count), 0, axis)
    return picture


def _averaged(rows, count):
    """Rows before each edge are summed; of the row that an edge divides, its part."""
    sums = np.concatenate([np.zeros((1, *rows.shape[1:])), np.cumsum(rows, axis=0, dtype=np.float64)])
    edges = np.arange(count + 1) * len(rows) / count
    whole = np.minimum(edges.astype(int), len(rows) - 1)
    before = sums[whole] + (edges - whole)[:, None, None] * rows[whole]
    return (np.diff(before, axis=0) * count / len(rows)).astype(rows.dtype)


def nearest(picture, width, height):
    """Each pixel is what is seen in its middle."""
    rows, columns = (((np.arange(count) + 0.5) * have / count).astype(int) for count, have in zip((height, width), picture.shape))
    return picture[rows[:, None], columns]
