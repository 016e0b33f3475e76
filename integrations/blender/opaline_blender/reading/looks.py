"""How a material is shown."""

import dataclasses

import numpy as np

from .. import subsurface
from . import mixtures, nodes


@dataclasses.dataclass(frozen=True)
class Look:
    """Everything about a material that decides pixels. Lengths are in mm."""

    name: str = ""
    medium: str = ""  # one of ours by name; if empty, the following apply
    color: tuple = (0.8, 0.8, 0.8)
    color_picture: nodes.Picture = None
    radius_mm: tuple = None  # of a body that light enters
    radius_kind: str = subsurface.FIXED
    anisotropy: float = 0.0
    subsurface_ior: float = 1.4
    metallic: float = 0.0
    metallic_picture: nodes.Picture = None
    roughness: float = 0.5
    roughness_picture: nodes.Picture = None
    ior: float = 1.5
    specular: float = 1.0
    normal_picture: nodes.Picture = None
    normal_scale: float = 1.0
    emission: tuple = (0.0, 0.0, 0.0)
    emission_picture: nodes.Picture = None
    alpha: float = 1.0
    is_cut_out: bool = False  # where alpha, including that of the colours' picture, is below a half
    unlit: bool = False
    through: float = 0.0  # share of the light given back diffusely that leaves the other side instead
    through_color: tuple = (1.0, 1.0, 1.0)
    through_picture: nodes.Picture = None

    @property
    def is_translucent(self):
        return bool(self.medium) or self.radius_mm is not None

    @property
    def has_pictures(self):
        return any(isinstance(getattr(self, field.name), nodes.Picture) for field in dataclasses.fields(self))


GREY = Look()

MOST_REFLECTANCE = 0.66  # head on, for an index of 10


def _ior_of_reflectance(head_on):
    root = head_on ** 0.5
    return (1 + root) / (1 - root)


def _reflection(node):
    """An index of refraction with the surface's head-on reflectance, and 1 or 0 for whether it reflects at all."""
    if nodes.socket(node, "Specular IOR Level") is not None:
        # 4.x: a factor on the reflectance of the index (Cycles 4.0, kernel/svm/closure.h).
        ior = nodes.number(node, 1.5, "IOR")
        head_on = ((ior - 1) / (ior + 1)) ** 2 * 2 * nodes.number(node, 0.5, "Specular IOR Level")
    else:
        # 3.x: 1 means eight per cent of reflection (Burley 2012).
        head_on = 0.08 * nodes.number(node, 0.5, "Specular")
    head_on = min(max(head_on, 0), MOST_REFLECTANCE)
    return (_ior_of_reflectance(head_on), 1.0) if head_on > 0 else (1.5, 0.0)


def _normal(node, notes, name):
    behind = nodes.source(nodes.socket(node, "Normal"))
    if behind is None:
        return None, 1.0
    if behind.node.type != "NORMAL_MAP" or behind.node.space != "TANGENT":
        notes.add("bumps and normal maps but those in tangent space are not shown", name)
        return None, 1.0
    return nodes.picture(behind.node.inputs["Color"], notes, name), behind.node.inputs["Strength"].default_value


def _textured(node, default, notes, name, socket):
    """A number, and the picture that it multiplies."""
    picture = nodes.picture(nodes.socket(node, socket), notes, name)
    return 1.0 if picture else nodes.number(node, default, socket), picture


MATT_METAL = 0.4  # roughness beyond which facets reflect more than 3 % of the light to each other


def _note_metal(node, notes, name, metallic, roughness):
    """Both arguments are a number and the picture that it multiplies."""
    is_metal = metallic[0] > 0 or metallic[1] is not None
    is_rough = roughness[0] > MATT_METAL or roughness[1] is not None
    if getattr(node, "distribution", "") == "GGX" and is_metal and is_rough:
        notes.add("rough metal is shown as by Multiscatter GGX", name)


def _note_what_is_left(node, notes, name):
    for what, *names in (("clearcoat", "Clearcoat", "Coat Weight"), ("sheen", "Sheen", "Sheen Weight"),
                         ("the roughness of diffuse reflection", "Diffuse Roughness"), ("a thin film", "Thin Film Thickness")):
        if nodes.number(node, 0, *names) > 0:
            notes.add(f"{what} is not shown", name)
    if nodes.number(node, 0, "Transmission Weight", "Transmission") > 0:
        notes.add("transmission is not shown: what is clear is shown as opaque", name)
    if nodes.number(node, 0, "Anisotropic") > 0:
        notes.add("anisotropic reflection is not shown", name)
    tint = nodes.socket(node, "Specular Tint")  # a strength in 3.x, a colour in 4.x
    if tint is not None and np.any(np.array(tint.default_value) != (0 if tint.type == "VALUE" else 1)):
        notes.add("the tint of reflections is not shown", name)


def _scattering(node, look, mm_per_unit, notes):
    """The look with the subsurface scattering of a Principled BSDF, if it has some."""
    weight = nodes.number(node, 0, "Subsurface Weight", "Subsurface")
    if weight <= 0 or look.metallic >= 1:
        return look
    radius = np.array(nodes.vector(node, (1, 0.2, 0.1), "Subsurface Radius"))
    color, picture = look.color, look.color_picture
    own = nodes.socket(node, "Subsurface Color")
    if own is not None:  # 3.x: the weight scales the radius and mixes two colours
        radius = radius * weight
        tint = np.array(nodes.vector(node, color, "Subsurface Color"))
        if weight >= 0.5 and nodes.source(own) is not None:
            picture = nodes.picture(own, notes, look.name) or picture
        color = tuple((1 - weight) * np.array(color) + weight * tint)
    else:
        radius = radius * nodes.number(node, 0.05, "Subsurface Scale")
        if weight < 1:
            notes.add("a subsurface weight below 1 is shown as 1", look.name)
    if look.is_cut_out:
        notes.add("alpha of what light enters is not shown", look.name)
    if look.metallic > 0:
        notes.add("metal mixed with subsurface is shown without metal", look.name)
    return dataclasses.replace(look, color=color, color_picture=picture, radius_mm=tuple(radius * mm_per_unit),
                               radius_kind=subsurface.kind_of(node.subsurface_method),
                               subsurface_ior=nodes.number(node, 1.4, "Subsurface IOR"),
                               anisotropy=nodes.number(node, 0, "Subsurface Anisotropy"), metallic=0.0)


def _principled(node, name, mm_per_unit, notes):
    ior, specular = _reflection(node)
    normal, normal_scale = _normal(node, notes, name)
    strength = nodes.number(node, 1, "Emission Strength")
    emission = strength * np.array(nodes.vector(node, (0, 0, 0), "Emission Color", "Emission"))
    emission_picture = nodes.picture(nodes.socket(node, "Emission Color", "Emission"), notes, name)
    color_picture = nodes.picture(nodes.socket(node, "Base Color"), notes, name)
    metallic, metallic_picture = _textured(node, 0, notes, name, "Metallic")
    roughness, roughness_picture = _textured(node, 0.5, notes, name, "Roughness")
    if roughness_picture and metallic_picture and roughness_picture.place() != metallic_picture.place():
        notes.add("pictures of metallic and roughness lie as that of roughness does", name)
    alpha, is_cut_out = nodes.mask(nodes.socket(node, "Alpha"), color_picture, notes, name)
    _note_what_is_left(node, notes, name)
    _note_metal(node, notes, name, (metallic, metallic_picture), (roughness, roughness_picture))
    look = Look(name=name, color=nodes.vector(node, (0.8, 0.8, 0.8), "Base Color"), color_picture=color_picture,
                metallic=metallic, metallic_picture=metallic_picture, roughness=roughness, roughness_picture=roughness_picture,
                ior=ior, specular=specular,
                normal_picture=normal, normal_scale=normal_scale,
                emission=(strength,) * 3 if emission_picture else tuple(emission), emission_picture=emission_picture,
                alpha=alpha, is_cut_out=is_cut_out)
    return _scattering(node, look, mm_per_unit, notes)


def _diffuse(node, name, mm_per_unit, notes):
    del mm_per_unit
    return Look(name=name, color=nodes.vector(node, (0.8, 0.8, 0.8), "Color"),
                color_picture=nodes.picture(nodes.socket(node, "Color"), notes, name), roughness=1.0, specular=0.0)


def _glossy(node, name, mm_per_unit, notes):
    del mm_per_unit
    return Look(name=name, color=nodes.vector(node, (0.8, 0.8, 0.8), "Color"), metallic=1.0,
                color_picture=nodes.picture(nodes.socket(node, "Color"), notes, name),
                roughness=nodes.number(node, 0.5, "Roughness"))


def _emission(node, name, mm_per_unit, notes):
    del mm_per_unit
    picture = nodes.picture(nodes.socket(node, "Color"), notes, name)
    strength = nodes.number(node, 1, "Strength")
    color = (1, 1, 1) if picture else nodes.vector(node, (1, 1, 1), "Color")
    return Look(name=name, color=(0, 0, 0), specular=0.0, emission=tuple(strength * np.array(color)), emission_picture=picture)


def _subsurface(node, name, mm_per_unit, notes):
    radius = np.array(nodes.vector(node, (1, 0.2, 0.1), "Radius")) * nodes.number(node, 1, "Scale") * mm_per_unit
    return Look(name=name, color=nodes.vector(node, (0.8, 0.8, 0.8), "Color"),
                color_picture=nodes.picture(nodes.socket(node, "Color"), notes, name), radius_mm=tuple(radius),
                radius_kind=subsurface.kind_of(node.falloff), subsurface_ior=nodes.number(node, 1.4, "IOR"),
                anisotropy=nodes.number(node, 0, "Anisotropy"), specular=0.0)


def _translucent(node, name, mm_per_unit, notes):
    del mm_per_unit
    return Look(name=name, color=(0, 0, 0), roughness=1.0, specular=0.0, through=1.0,
                through_color=nodes.vector(node, (0.8, 0.8, 0.8), "Color"),
                through_picture=nodes.picture(nodes.socket(node, "Color"), notes, name))


SHADERS = {"BSDF_PRINCIPLED": _principled, "BSDF_DIFFUSE": _diffuse, "BSDF_GLOSSY": _glossy, "EMISSION": _emission,
           "SUBSURFACE_SCATTERING": _subsurface, "BSDF_TRANSLUCENT": _translucent}


def _look_behind(of, name, mm_per_unit, notes, deepest=32):
    """The look of the shader to which a socket is linked; None if it is not supported."""
    behind = nodes.source(of)
    if behind is None or deepest == 0:
        return None
    node = behind.node
    if node.type in SHADERS:
        return SHADERS[node.type](node, name, mm_per_unit, notes)
    inputs = [entry for entry in node.inputs if entry.type == "SHADER"]
    if node.type not in ("MIX_SHADER", "ADD_SHADER") or not inputs:
        return None

    def look_of_input(index):
        return _look_behind(inputs[index], name, mm_per_unit, notes, deepest - 1)

    return mixtures.look_of(node, inputs, look_of_input, name, notes)


def look_of(material, mm_per_unit, notes):
    """The look of a bpy.types.Material, or of None."""
    if material is None:
        return GREY
    chosen = getattr(material, "opaline", None)
    own = chosen.medium if chosen is not None else "SHADER"
    look = _by_shader(material, mm_per_unit, notes)
    if own == "SHADER":
        return look
    return dataclasses.replace(look, medium=own, radius_mm=None, color_picture=None, metallic=0.0)


def _by_shader(material, mm_per_unit, notes):
    name = material.name
    if not material.use_nodes or material.node_tree is None:
        return Look(name=name, color=tuple(material.diffuse_color)[:3], metallic=material.metallic, roughness=material.roughness)
    output = material.node_tree.get_output_node("CYCLES") or material.node_tree.get_output_node("ALL")
    if output is not None and output.inputs["Volume"].is_linked:
        notes.add("volumes are not shown", name)
    if output is not None and output.inputs["Displacement"].is_linked:
        notes.add("displacement by materials is not shown", name)
    look = _look_behind(output.inputs["Surface"], name, mm_per_unit, notes) if output is not None else None
    if look is None:
        notes.add("materials whose shader is not known are shown in grey", name)
        return dataclasses.replace(GREY, name=name)
    return look
