"""A scene at one moment, as plain descriptions."""

import dataclasses
import functools

import numpy as np

from .. import units
from . import lights, looks, meshes, world

MOST_LIGHTS = 16


@dataclasses.dataclass
class Body:
    name: str
    mesh: meshes.Mesh  # in our axes, mm
    look: looks.Look

    def is_same(self, other):
        return self.name == other.name and self.look == other.look and self.mesh.is_same(other.mesh)


def _properties(light):
    """The properties of an opaline light."""
    return [(name, np.asarray(getattr(light, name)).tolist()) for name in dir(light) if not name.startswith("_")]


@dataclasses.dataclass
class Snapshot:
    bodies: list
    lights: list
    world: world.World

    @functools.cached_property
    def bounds(self):
        """Opposite corners of the box around all bodies, mm; there must be a body."""
        lows, highs = zip(*(body.mesh.bounds for body in self.bodies))
        return np.min(lows, axis=0), np.max(highs, axis=0)

    def is_same(self, other):
        """Whether both look the same: Blender reports many changes that have no visible effect."""
        return (self.world == other.world and len(self.bodies) == len(other.bodies) and len(self.lights) == len(other.lights) and
                all(type(a) is type(b) and _properties(a) == _properties(b) for a, b in zip(self.lights, other.lights)) and
                all(a.is_same(b) for a, b in zip(self.bodies, other.bodies)))


def _placed(part, matrix, mm_per_unit):
    """A mesh in our axes. A mirrored one is turned inside out, so that its triangles keep their orientation."""
    matrix = np.array(matrix, dtype=np.float64)
    linear = matrix[:3, :3]
    positions = units.turned(part.positions @ linear.T + matrix[:3, 3]) * mm_per_unit
    determinant = np.linalg.det(linear)
    normals = part.normals
    if abs(determinant) > 1e-30:
        normals = units.turned(part.normals @ np.linalg.inv(linear))
        lengths = np.linalg.norm(normals, axis=1, keepdims=True)
        normals = normals / np.maximum(lengths, 1e-30)
    triangles = part.triangles if determinant >= 0 else part.triangles[:, ::-1]
    return meshes.Mesh(positions.astype(np.float32), normals.astype(np.float32), part.coordinates, np.ascontiguousarray(triangles))


class Reader:
    """Reads what a depsgraph shows. A mesh that several instances share is read once."""

    def __init__(self, depsgraph, mm_per_unit, notes):
        self._depsgraph = depsgraph
        self._mm_per_unit = mm_per_unit
        self._notes = notes
        self._looks = {}
        self._parts = {}

    def read(self):
        bodies, found = [], []
        for instance in self._depsgraph.object_instances:
            if not instance.show_self:
                continue
            thing = instance.object
            if thing.type == "LIGHT":
                light = lights.light_of(thing.data, instance.matrix_world, self._notes, self._mm_per_unit)
                if light is not None:
                    found.append(light)
            elif thing.type in ("MESH", "CURVE", "SURFACE", "META", "FONT"):
                bodies.extend(self._bodies(instance))
            elif thing.type in ("CURVES", "HAIR", "POINTCLOUD", "VOLUME", "GPENCIL", "GREASEPENCIL"):
                self._notes.add("hair, points, volumes and strokes are not shown", thing.name)
        if len(found) > MOST_LIGHTS:
            self._notes.add(f"of {len(found)} lamps, the first {MOST_LIGHTS} shine")
            found = found[:MOST_LIGHTS]
        return Snapshot(bodies, found, world.world_of(self._depsgraph.scene_eval.world, self._notes))

    def _look(self, material):
        key = material.name_full if material is not None else None
        if key not in self._looks:
            self._looks[key] = looks.look_of(material, self._mm_per_unit, self._notes)
        return self._looks[key]

    def _looks_of(self, thing):
        slots = [slot.material for slot in thing.material_slots] or [None]
        return [self._look(material) for material in slots]

    def _parts_of(self, thing, with_coordinates):
        key = (thing.original.name_full if thing.original else thing.name_full, thing.data.name_full if thing.data else "",
               with_coordinates)
        if key not in self._parts:
            mesh = thing.to_mesh()
            try:
                self._parts[key] = meshes.parts_of(mesh, with_coordinates) if mesh is not None else {}
            finally:
                thing.to_mesh_clear()
        return self._parts[key]

    def _bodies(self, instance):
        thing = instance.object
        of_slots = self._looks_of(thing)
        with_coordinates = any(look.has_pictures for look in of_slots)
        parts = self._parts_of(thing, with_coordinates)
        if len(parts) > 1 and any(of_slots[min(slot, len(of_slots) - 1)].is_translucent for slot in parts):
            self._notes.add("each material of an object is a body of its own, open where they meet", thing.name)
        for slot, part in parts.items():
            look = of_slots[min(slot, len(of_slots) - 1)]
            yield Body(thing.name, _placed(part, instance.matrix_world, self._mm_per_unit), look)
