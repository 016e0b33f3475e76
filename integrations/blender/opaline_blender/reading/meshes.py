"""Evaluated meshes as arrays, without a loop over vertices."""

import dataclasses
import functools

import numpy as np


@dataclasses.dataclass
class Mesh:
    """A mesh in the object's own space. Vertices that differ in normal or texture coordinates are separate."""

    positions: np.ndarray  # (N, 3)
    normals: np.ndarray  # (N, 3)
    coordinates: np.ndarray  # (N, 2), v down, or None
    triangles: np.ndarray  # (M, 3)

    @functools.cached_property
    def bounds(self):
        """Two opposite corners of its box."""
        return self.positions.min(axis=0), self.positions.max(axis=0)

    def is_like(self, other):
        """Whether only the positions of the vertices differ."""
        return (self.positions.shape == other.positions.shape and np.array_equal(self.triangles, other.triangles) and
                (self.coordinates is None) == (other.coordinates is None) and
                (self.coordinates is None or np.array_equal(self.coordinates, other.coordinates)))

    def is_same(self, other):
        return (self.is_like(other) and np.array_equal(self.positions, other.positions) and
                np.array_equal(self.normals, other.normals))


def _taken(collection, name, kind, width):
    values = np.empty(len(collection) * width, dtype=kind)
    collection.foreach_get(name, values)
    return values.reshape(-1, width) if width > 1 else values


def _corner_normals(mesh):
    if hasattr(mesh, "corner_normals"):  # 4.1
        return _taken(mesh.corner_normals, "vector", np.float32, 3)
    mesh.calc_normals_split()
    return _taken(mesh.loops, "normal", np.float32, 3)


def _coordinates(mesh):
    layers = mesh.uv_layers
    if not layers:
        return None
    layer = next((layer for layer in layers if layer.active_render), layers[0])
    coordinates = _taken(layer.data, "uv", np.float32, 2)
    return np.stack([coordinates[:, 0], 1 - coordinates[:, 1]], axis=1)


SAME_NORMAL = 1e-3


def _numbered(values):
    """For whole numbers: where each distinct one comes first, and the index of each among the distinct ones, in order
    of appearance. Needs no sorting."""
    first = np.full(values.max() + 1, -1, dtype=np.int64)
    first[values[::-1]] = np.arange(len(values) - 1, -1, -1)
    there = np.flatnonzero(first >= 0)
    rank = np.empty(len(first), dtype=np.int64)
    rank[there] = np.arange(len(there))
    return first[there], rank[values]


def _rounded(normals):
    """Rounds normals, so that rounding errors do not make them differ."""
    return np.rint(normals * 8192).astype(np.int32)


def _joined(vertices, normals, coordinates):
    """Which corner stands for each new vertex, and the new vertex of each corner."""
    if coordinates is None:
        first, which = _numbered(vertices)
        if np.abs(normals - normals[first[which]]).max() < SAME_NORMAL:
            return first, which
    columns = [vertices.astype(np.int32)[:, None], _rounded(normals)]
    if coordinates is not None:
        columns.append(coordinates.view(np.int32))
    rows = np.ascontiguousarray(np.concatenate(columns, axis=1))
    _, first, which = np.unique(rows.view(np.dtype((np.void, rows.itemsize * rows.shape[1]))).ravel(), return_index=True,
                                return_inverse=True)
    # In the order of the mesh, which stays the same between frames.
    order = np.argsort(first, kind="stable")
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return first[order], rank[which.ravel()]


def parts_of(mesh, with_coordinates):
    """Material index -> Mesh, of an evaluated bpy.types.Mesh."""
    mesh.calc_loop_triangles()
    if len(mesh.loop_triangles) == 0:
        return {}
    corners = _taken(mesh.loop_triangles, "loops", np.int32, 3)
    materials = _taken(mesh.loop_triangles, "material_index", np.int32, 1)
    positions = _taken(mesh.vertices, "co", np.float32, 3)
    vertices = _taken(mesh.loops, "vertex_index", np.int32, 1)
    normals = _corner_normals(mesh)
    coordinates = _coordinates(mesh) if with_coordinates else None
    parts = {}
    for material in np.unique(materials):
        chosen = corners[materials == material]
        flat = chosen.ravel()
        first, where = _numbered(flat)
        used = flat[first]
        first, which = _joined(vertices[used], normals[used],
                               np.ascontiguousarray(coordinates[used]) if coordinates is not None else None)
        kept = used[first]
        parts[int(material)] = Mesh(positions[vertices[kept]], normals[kept], coordinates[kept] if coordinates is not None else None,
                                    which[where.reshape(chosen.shape)].astype(np.uint32))
    return parts
