"""Lamps, in the units that Cycles gives them."""

import math

import numpy as np

from .. import units

SHARP_SUN_DEGREES = 3  # shadows of larger suns are visibly soft
MOST_SUN_DEGREES = 20  # that are mirrored


def _directions(matrix):
    """The lamp's axes, with their scale, in our axes."""
    return units.turned(np.array(matrix, dtype=float)[:3, :3].T)


def _color(lamp):
    color = np.array(lamp.color, dtype=float)
    return np.maximum(color, 0)


def _sun(lamp, place, axes, notes, mm_per_unit):
    import opaline

    del place, mm_per_unit
    if math.degrees(lamp.angle) > SHARP_SUN_DEGREES:
        notes.add("the size of suns is shown in reflections alone: their shadows are sharp", lamp.name)
    return opaline.DirectionalLight(axes[2], irradiance=_color(lamp) * lamp.energy,
                                    angular_radius_degrees=min(math.degrees(lamp.angle), MOST_SUN_DEGREES) / 2)


def _point(lamp, place, axes, notes, mm_per_unit):
    import opaline

    del axes, notes
    power = _color(lamp) * lamp.energy
    radius = lamp.shadow_soft_size
    if radius * mm_per_unit < 1e-3:
        return opaline.PointLight(place, intensity=power / (4 * math.pi) * mm_per_unit ** 2)
    return opaline.SphereLight(place, radius * mm_per_unit, radiance=power / (4 * math.pi ** 2 * radius ** 2))


def _spot(lamp, place, axes, notes, mm_per_unit):
    import opaline

    if lamp.shadow_soft_size > 0:
        notes.add("the size of spot lamps is not shown: their shadows are sharp", lamp.name)
    outer = min(lamp.spot_size / 2, math.pi / 2)
    # Cycles' falloff from the rim is a smooth step of the cosine, ours a square. Over three quarters of the width, ours
    # lets the same light through.
    rim = math.cos(outer)
    inner = math.acos(min(rim + 0.75 * (1 - rim) * lamp.spot_blend, 1))
    return opaline.SpotLight(place, -axes[2], intensity=_color(lamp) * lamp.energy / (4 * math.pi) * mm_per_unit ** 2,
                             inner_degrees=math.degrees(inner), outer_degrees=math.degrees(outer))


def _of_power(area):
    """Radiance per watt: from 4.0 on that of a matt surface, before that less by a factor of pi / 4."""
    import bpy

    return 1 / ((math.pi if bpy.app.version >= (4, 0, 0) else 4) * area)


def _area(lamp, place, axes, notes, mm_per_unit):
    import opaline

    width = lamp.size
    height = lamp.size_y if lamp.shape in ("RECTANGLE", "ELLIPSE") else lamp.size
    u, v = axes[0] * width / 2, axes[1] * height / 2
    lengths = np.linalg.norm(u), np.linalg.norm(v)
    if min(lengths) * mm_per_unit < 1e-4:
        notes.add("an area lamp without an area gives no light", lamp.name)
        return None
    is_round = lamp.shape in ("DISK", "ELLIPSE")
    area = (math.pi if is_round else 4) * lengths[0] * lengths[1]
    radiance = _color(lamp) * lamp.energy * _of_power(area)
    if getattr(lamp, "spread", math.pi) < math.pi * 0.99:
        notes.add("the spread of area lamps is not shown", lamp.name)
    if is_round and abs(lengths[0] - lengths[1]) < 0.01 * max(lengths):
        return opaline.DiscLight(place, -axes[2], lengths[0] * mm_per_unit, radiance=radiance)
    if is_round:
        notes.add("elliptic lamps are shown as rectangles of their area", lamp.name)
        u, v = u * math.sqrt(math.pi) / 2, v * math.sqrt(math.pi) / 2
    return opaline.RectangleLight(place, v * mm_per_unit, u * mm_per_unit, radiance=radiance)


KINDS = {"SUN": _sun, "POINT": _point, "SPOT": _spot, "AREA": _area}


def light_of(lamp, matrix, notes, mm_per_unit):
    """The opaline light of a bpy.types.Light; None where it does not shine."""
    if lamp.energy == 0 or not any(lamp.color):
        return None
    if lamp.energy < 0:
        notes.add("lamps that take light away are not shown", lamp.name)
        return None
    if lamp.use_nodes and lamp.node_tree and any(node.type not in ("EMISSION", "OUTPUT_LIGHT") for node in lamp.node_tree.nodes):
        notes.add("the nodes of lamps are not shown", lamp.name)
    matrix = np.array(matrix, dtype=float)
    place = units.turned(matrix[:3, 3]) * mm_per_unit
    return KINDS[lamp.type](lamp, place, _directions(matrix), notes, mm_per_unit)
