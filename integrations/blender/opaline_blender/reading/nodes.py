"""Values and pictures behind the sockets of shader nodes."""

import dataclasses

from . import images


@dataclasses.dataclass(frozen=True)
class Picture:
    """An image texture that a socket is linked to."""

    image: object  # bpy.types.Image
    wrap: str
    interpolated: bool
    transform: tuple  # two rows, from coordinates with v down
    channel: int = None  # red, green, blue or alpha, if it is a single channel
    state: tuple = ()  # of its pixels

    def place(self):
        """How the picture lies on a surface."""
        return self.wrap, self.interpolated, self.transform

    def key(self):
        return self.image.name_full, self.channel, *self.place()


WRAPS = {"REPEAT": "repeat", "EXTEND": "clamp", "CLIP": "clamp", "MIRROR": "mirror"}
ALPHA = 3
UNTURNED = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))


def socket(node, *names):
    """The node's input with the first of these names that it has: they differ between 3.x and 4.x."""
    for name in names:
        for candidate in node.inputs:
            if candidate.name == name and candidate.enabled:
                return candidate
    return None


def source(of):
    """The output to which a socket is linked, through reroutes; None if there is none."""
    while of is not None and of.is_linked and of.links:
        link = of.links[0]
        if link.is_muted:
            return None
        if link.from_node.type != "REROUTE":
            return link.from_socket
        of = link.from_node.inputs[0]
    return None


def value(of, default):
    """The number in a socket, or the default without a socket."""
    if of is None:
        return default
    behind = source(of)
    if behind is not None and behind.node.type == "VALUE":
        return behind.default_value
    return of.default_value


def number(node, default, *names):
    return value(socket(node, *names), default)


def vector(node, default, *names):
    found = socket(node, *names)
    if found is None:
        return tuple(default)
    behind = source(found)
    if behind is not None and behind.node.type == "RGB":
        return tuple(behind.default_value)[:3]
    return tuple(found.default_value)[:3]


def _transform(node, notes, name):
    """The transform of the Mapping node before an image; of its turns only the one about z counts."""
    import math

    behind = source(socket(node, "Vector"))
    if behind is None or behind.node.type in ("TEX_COORD", "UVMAP"):
        if behind is not None and behind.node.type == "TEX_COORD" and behind.name != "UV":
            notes.add("textures lie on UV coordinates, whatever others their nodes name", name)
        return UNTURNED
    if behind.node.type != "MAPPING" or behind.node.vector_type != "POINT":
        notes.add("nodes before image textures are not shown", name)
        return UNTURNED
    x, y, _ = behind.node.inputs["Location"].default_value
    turn = behind.node.inputs["Rotation"].default_value[2]
    sx, sy, _ = behind.node.inputs["Scale"].default_value
    c, s = math.cos(turn), math.sin(turn)
    # Blender maps (u, v) to (c sx u - s sy v + x, s sx u + c sy v + y); here v is 1 - v on both sides.
    return (c * sx, s * sy, x - s * sy), (-s * sx, c * sy, 1 - y - c * sy)


def picture(of, notes, name):
    """The Picture to which a socket is linked; None where it is not linked, or to something unsupported."""
    behind = source(of)
    if behind is None or behind.node.type in ("RGB", "VALUE"):
        return None
    node, channel = behind.node, None
    if node.type in ("SEPARATE_COLOR", "SEPRGB") and getattr(node, "mode", "RGB") == "RGB":
        channel = list(node.outputs).index(behind)
        behind = source(node.inputs[0])
        node = behind.node if behind is not None else node
    elif node.type == "TEX_IMAGE" and behind.name == "Alpha":
        channel = ALPHA
    if node.type != "TEX_IMAGE" or node.image is None:
        notes.add("nodes but image textures, colours and values are not shown; the socket's own value is used", name)
        return None
    return Picture(node.image, WRAPS.get(node.extension, "repeat"), node.interpolation != "Closest", _transform(node, notes, name),
                   channel, images.state_of(node.image))


def mask(of, color_picture, notes, name):
    """The alpha of a socket, and whether the surface ends where it is below a half."""
    found = picture(of, notes, name)
    if found is not None:
        notes.add("alpha is shown as a mask, which ends at a half", name)
        if color_picture is None or found.image != color_picture.image or found.channel != ALPHA:
            notes.add("alpha but that of the base color's picture is not shown", name)
            return 1.0, False
        return 1.0, True
    alpha = value(of, 1)
    if alpha < 1:
        notes.add("alpha is shown as a mask, which ends at a half", name)
    return alpha, alpha < 0.5
