"""Inputs as Blender 4.x names them, by stand-ins for its nodes."""

import math
import pathlib
import sys
import types
from unittest import mock

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import common

common.install()
from opaline_blender import subsurface
from opaline_blender.notes import Notes
from opaline_blender.reading import looks


def principled(method="RANDOM_WALK_SKIN", distribution="MULTI_GGX", **inputs):
    """With the inputs of 4.x that are read, and its defaults."""
    values = {"Base Color": (0.8, 0.5, 0.3, 1), "Metallic": 0.0, "Roughness": 0.5, "IOR": 1.5, "Alpha": 1.0,
              "Normal": (0, 0, 0), "Subsurface Weight": 0.0, "Subsurface Radius": (1, 0.2, 0.1), "Subsurface Scale": 0.05,
              "Subsurface IOR": 1.4, "Subsurface Anisotropy": 0.0, "Specular IOR Level": 0.5, "Specular Tint": (1, 1, 1, 1),
              "Anisotropic": 0.0, "Transmission Weight": 0.0, "Coat Weight": 0.0, "Sheen Weight": 0.0, "Diffuse Roughness": 0.0,
              "Thin Film Thickness": 0.0,
              "Emission Color": (1, 1, 1, 1), "Emission Strength": 0.0}
    values.update(inputs)
    sockets = [types.SimpleNamespace(name=name, default_value=value, type="RGBA" if np.ndim(value) else "VALUE", is_linked=False,
                                     links=[], enabled=True) for name, value in values.items()]
    return types.SimpleNamespace(type="BSDF_PRINCIPLED", inputs=sockets, subsurface_method=method, distribution=distribution)


def look_of(node):
    notes = Notes()
    with mock.patch.object(bpy, "app", types.SimpleNamespace(version=(4, 2, 0))):
        return looks.SHADERS[node.type](node, "Newer", 1000, notes), list(notes.sentences())


def near(found, wanted, what):
    common.check(np.allclose(found, wanted, rtol=1e-5), f"{what}: {found} instead of {wanted}")


plain, said = look_of(principled())
common.check(not plain.is_translucent and not said, f"the defaults of 4.x are a matt surface without notes: {said}")
near(plain.ior, 1.5, "index of refraction")
near(plain.emission, (0, 0, 0), "emission")
near(look_of(principled(**{"Emission Strength": 2.0, "Emission Color": (1, 0.5, 0, 1)}))[0].emission, (2, 1, 0), "emission")
# Half of the level is half of the reflection head on, and none is none.
half = look_of(principled(**{"Specular IOR Level": 0.25}))[0]
near(((half.ior - 1) / (half.ior + 1)) ** 2, 0.02, "reflectance")
near(look_of(principled(**{"Specular IOR Level": 0.0}))[0].specular, 0, "specular")

# The radius times the scale, in mm.
skin, said = look_of(principled(**{"Subsurface Weight": 1.0, "Subsurface Scale": 0.01}))
near(skin.radius_mm, (10, 2, 1), "radius")
common.check(skin.radius_kind == subsurface.ADJUSTED and not said, "Random Walk (Skin) adjusts its radius")
common.check(look_of(principled("RANDOM_WALK", **{"Subsurface Weight": 1.0}))[0].radius_kind == subsurface.ALONG_VIEW,
             "Random Walk of 4.x keeps its radius")
common.check(look_of(principled("BURLEY", **{"Subsurface Weight": 1.0}))[0].radius_kind == subsurface.FIXED, "Burley keeps its radius")
near(subsurface.mean_free_path(1, 0.5, subsurface.FIXED, 1.4), 1 / (4 * math.pi), "mean free path")

_, said = look_of(principled(**{"Subsurface Weight": 0.5, "Coat Weight": 0.2, "Sheen Weight": 0.1, "Transmission Weight": 1.0,
                                "Diffuse Roughness": 0.4, "Thin Film Thickness": 300.0, "Specular Tint": (1, 0.5, 0.5, 1)}))
for word in ("weight below 1", "clearcoat", "sheen", "transmission", "diffuse", "thin film", "tint"):
    common.check(any(word in sentence for sentence in said), f"nothing is said of {word}: {said}")

metal = {"Metallic": 1.0, "Roughness": 0.7}
common.check(not look_of(principled(**metal))[1], "something is said of rough metal whose facets send on light")
_, said = look_of(principled(distribution="GGX", **metal))
common.check(any("Multiscatter" in sentence for sentence in said), f"nothing is said of rough metal: {said}")
