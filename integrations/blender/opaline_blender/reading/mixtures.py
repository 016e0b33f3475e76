"""How mixed shaders are shown."""

import dataclasses

from . import nodes


def look_of(node, inputs, look_of_input, name, notes):
    """The look of a Mix Shader or an Add Shader: a sheet that lets light through if one of the two is Translucent, a
    mask if the first is Transparent, and otherwise one of the two."""
    kinds = [_kind(entry) for entry in inputs]
    factor = nodes.socket(node, "Fac", "Factor") if node.type == "MIX_SHADER" else None
    if len(kinds) == 2 and kinds.count("BSDF_TRANSLUCENT") == 1:
        through = kinds.index("BSDF_TRANSLUCENT")
        look = _sheet(look_of_input(1 - through), look_of_input(through), factor, through == 0, name, notes)
        if look is not None:
            return look
    if factor is not None and kinds[0] == "BSDF_TRANSPARENT":
        look = look_of_input(1)
        if look is None:
            return None
        alpha, is_cut_out = nodes.mask(factor, look.color_picture, notes, name)
        return dataclasses.replace(look, alpha=alpha, is_cut_out=is_cut_out)
    notes.add("of mixed shaders one is shown", name)
    look = look_of_input(1 if nodes.value(factor, 0) > 0.5 else 0)
    return look if look is not None else look_of_input(-1)


def _kind(entry):
    behind = nodes.source(entry)
    return behind.node.type if behind is not None else ""


def _sheet(front, translucent, factor, is_reversed, name, notes):
    """A sheet for a mix. Cycles mixes reflected and transmitted light; here a share of what would be reflected is
    transmitted. None where that would look different."""
    if front is None or front.is_translucent or front.metallic > 0 or front.metallic_picture is not None:
        return None
    shown = {"through_color": translucent.through_color, "through_picture": translucent.through_picture}
    if factor is not None:
        if nodes.picture(factor, notes, name) is not None:
            notes.add("factors of mixed shaders are numbers, not pictures", name)
        share = min(max(nodes.value(factor, 0.5), 0), 1)
        share = 1 - share if is_reversed else share
        return dataclasses.replace(front, through=share, specular=front.specular * (1 - share),
                                   emission=tuple((1 - share) * each for each in front.emission), **shown)
    if front.color_picture is not None or translucent.through_picture is not None:
        return None
    # In a sum, both parts keep their light.
    most = max(front.color), max(translucent.through_color)
    if most[1] <= 0:
        return front
    share = most[1] / (most[0] + most[1])
    color = tuple(each / (1 - share) for each in front.color) if share < 1 else front.color
    shown["through_color"] = tuple(each / share for each in translucent.through_color)
    return dataclasses.replace(front, color=color, through=share, **shown)
