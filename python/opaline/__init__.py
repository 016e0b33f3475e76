"""Renders moving translucent objects: wax, jade, marble, milk, skin.

A picture of a bear of jade, and the light that leaves it:

    import opaline

    scene = opaline.bear(medium="jade", diagonal_mm=50)      # or opaline.load("file.glb")
    scene.lights = [opaline.DirectionalLight((0.6, 0, -0.8), irradiance=(6, 6, 5))]
    renderer = opaline.Renderer(scene)
    frame = renderer.render(width=640, height=480, aovs=["radiance", "exitance"])
    frame.save("bear.png")
    frame["exitance"]                                        # float32 (480, 640, 4), linear

A mesh of your own that moves:

    body = opaline.Object(positions_mm, triangles, medium="wax")
    renderer = opaline.Renderer(opaline.Scene([body]))
    renderer.set_positions(0, positions_mm + offsets)        # the next frame has it

How far a picture is from the truth:

    truth = opaline.integral(scene, 640, 480, aov="exitance")
    opaline.compare(frame["exitance"], truth["exitance"])["rel_rmse"]

Lengths are millimetres, y is up, light is linear RGB. Pictures are arrays (height, width, 4), float32: R G B A, row 0 at
the top, A is coverage. Errors are opaline.Error, a RuntimeError, and opaline.UsageError, also a ValueError. The library
prints nothing; notes and warnings go to logging.getLogger("opaline").
"""

import struct as _struct
import zlib as _zlib
from collections.abc import Mapping as _Mapping

from ._opaline import (Camera, DirectionalLight, DiscLight, Error, Medium, Object, OpaqueMaterial, Paint, PointLight,
                       RectangleLight, Renderer, Scene, SphereLight, SpotLight, Texture, TranslucentSurface, TubeLight,
                       UsageError, __version__, bear, compare, devices, integral, load, media, path, read_image, teapot, tone_map,
                       write_exr, write_png)

__all__ = ["Camera", "DirectionalLight", "DiscLight", "Error", "Frame", "Medium", "Object", "OpaqueMaterial", "Paint",
           "PointLight", "RectangleLight", "Renderer", "Scene", "SphereLight", "SpotLight", "Texture", "TranslucentSurface",
           "TubeLight", "UsageError", "bear", "compare", "devices", "integral", "load", "media", "path", "read_image", "teapot", "tone_map", "write_exr", "write_png"]

for _name in __all__[:]:
    if _name != "Frame":
        globals()[_name].__module__ = "opaline"


class Frame(_Mapping):
    """The pictures of one frame: a mapping from the name of a variable to its array (height, width, 4), float32.

    facts: how it was made, a dict; exposure_stops: what suits the light of its scene. Notebooks show it."""

    def __init__(self, pictures, facts, exposure_stops):
        self._pictures = pictures
        self.facts = facts
        self.exposure_stops = exposure_stops

    def __getitem__(self, name):
        return self._pictures[name]

    def __iter__(self):
        return iter(self._pictures)

    def __len__(self):
        return len(self._pictures)

    def __repr__(self):
        height, width = next(iter(self.values())).shape[:2]
        return f"<opaline.Frame {width}x{height}: {', '.join(self)}>"

    def tone_mapped(self, name=None, exposure_stops=None, curve="neutral", background=None):
        """A variable, the first without a name, to look at: array (height, width, 4), uint8, sRGB. See tone_map()."""
        stops = self.exposure_stops if exposure_stops is None else exposure_stops
        return tone_map(self[name or next(iter(self))], stops, curve, background)

    def save(self, file, name=None, exposure_stops=None, curve="neutral", background=None):
        """Writes a variable, the first without a name: .exr as it is, .png tone mapped."""
        ending = str(file).lower().rpartition(".")[2]
        picture = self[name or next(iter(self))]
        if ending == "exr":
            write_exr(file, picture)
        elif ending == "png":
            stops = self.exposure_stops if exposure_stops is None else exposure_stops
            write_png(file, picture, stops, curve, background)
        else:
            raise UsageError(f"{file} must end in .exr or .png.")

    def _repr_png_(self):
        pixels = self.tone_mapped()
        height, width = pixels.shape[:2]
        rows = b"".join(b"\0" + row.tobytes() for row in pixels)

        def chunk(kind, data):
            return _struct.pack(">I", len(data)) + kind + data + _struct.pack(">I", _zlib.crc32(kind + data))

        return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", _struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0))
                + chunk(b"IDAT", _zlib.compress(rows)) + chunk(b"IEND", b""))
