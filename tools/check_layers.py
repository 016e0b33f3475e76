#!/usr/bin/env python3
"""Checks which folder may include what. The table below is the only rule."""

import posixpath
import re
import sys

from repository import ROOT, finish, read_text, tracked_files

PLAIN = ("opaline/error.h", "opaline/file.h", "opaline/image.h", "opaline/image_file.h", "opaline/log.h", "opaline/numbered_name.h", "opaline/tone.h",
         "opaline/types.h")

# The program uses the library as anybody can, through its public headers.
APP = ("opaline", "reference")

# Below these folders, includes begin with one of their subfolders.
PROGRAMS = ("apps/opaline",)

# Folder (longest match wins) -> what it may include of ours. A folder name allows everything below it, a name that ends
# in .h just that header. A folder may always include itself; * allows everything but tests.
ALLOWED = {
    "include/opaline": ("opaline",),
    "src/core": PLAIN,
    "src/compare": (*PLAIN, "opaline/compare.h", "core"),
    "src/bssrdf": ("opaline/error.h", "opaline/half_space.h", "opaline/media.h", "opaline/medium.h", "opaline/render_options.h"),
    "src/options": ("opaline",),
    "src/scene": ("opaline", "core", "bssrdf", "builtin"),
    "src/lights": ("opaline", "bssrdf"),
    "src/environment": ("opaline", "core", "bssrdf", "lights"),
    "src/deform": ("opaline", "core", "scene"),
    "src/builtin": ("opaline", "core"),
    "src/surfels": (*PLAIN, "core"),
    "src/soft_body": (*PLAIN, "core"),
    "src/gpu": (*PLAIN, "opaline/vulkan.h", "core"),
    "src/shaders": ("bssrdf", "gpu/binding.h"),  # like the headers made from them
    "src/shaders/shared": (),  # GLSL reads these too
    "src/passes": ("opaline", "core", "surfels", "soft_body", "bssrdf", "environment", "gpu", "shaders",
                   "passes/products.h"),
    "src/paper": ("opaline", "core", "bssrdf", "gpu", "shaders", "passes/products.h",
                  "passes/seen_parts.h"),
    "src/paper/atlas": (*PLAIN, "opaline/atlas.h", "core"),
    "src/renderer": ("opaline", "core", "bssrdf", "lights", "scene", "environment", "deform", "surfels",
                     "soft_body", "gpu", "passes", "paper/atlas/atlas.h", "paper/technique.h", "shaders"),
    "src/c_interface": ("opaline",),
    "reference": ("opaline", "core", "bssrdf", "deform", "lights", "environment", "scene/changes.h", "scene/mesh/bodies.h", "scene/mesh/normals.h",
                  "scene/mesh/tangents.h", "scene/pose.h"),
    "apps/opaline/cli": APP,
    "apps/opaline/film": (*APP, "apps/opaline/cli"),
    "apps/opaline/lab": (*APP, "apps/opaline/cli", "apps/opaline/film"),
    "apps/opaline/viewer": (*APP, "apps/opaline/cli", "apps/opaline/film", "apps/opaline/lab",
                            "shaders/picture.vert.h", "shaders/picture.frag.h"),  # its own
    "bench": ("*",),
    "tools/figures": ("*",),
    "python": ("opaline", "reference"),
    "examples": ("opaline",),
    "tests": ("*", "tests"),
}

# Folders whose files may not include each other: passes are independent.
APART = ("src/passes",)

# Headers of other projects -> the folders that may include them. Headers not named here are free.
THIRD_PARTY = {
    "vulkan": ("include/opaline/vulkan.h", "src/c_interface/vulkan.cpp", "src/gpu", "src/passes", "src/paper", "src/renderer", "tests",
               "apps/opaline/viewer", "examples/vulkan"),
    "glm": ("src/shaders", "src/passes", "src/paper", "src/renderer", "src/gpu", "tests", "bench", "apps/opaline/viewer"),
    "embree3": ("reference", "tests", "bench"),
    "tbb": ("reference", "tests", "bench"),
    "GLFW": ("apps/opaline/viewer", "tests/app/viewer"),
    "imgui.h": ("apps/opaline/viewer", "tests/app/viewer"),
    "imgui": ("apps/opaline/viewer",),
    "fontconfig": ("apps/opaline/viewer",),
    "CLI": ("apps",),
    "pybind11": ("python",),
    "Python.h": ("python",),
    "gtest": ("tests",),
    "gmock": ("tests",),
    "benchmark": ("bench",),
}

# Folders that may only use themselves and the standard library.
STANDARD_ONLY = ("include/opaline", "src/bssrdf")
OF_C = ("stddef.h", "stdint.h")

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)
SOURCE = (".h", ".cpp", ".glsl")


def folder_name(layer):
    """A layer as includes spell it: src/core is core, include/opaline is opaline."""
    return re.sub(r"^(src|include)/", "", layer)


OUR_FOLDERS = {folder_name(layer).split("/")[0] for layer in ALLOWED}


def within(path, folder):
    return path == folder or path.startswith(folder + "/")


def layer_of(path):
    return max((folder for folder in ALLOWED if within(path, folder)), key=len, default=None)


def own_target(path, header):
    """Our file that an include means, as written below src/ or include/; None if it is foreign."""
    if header.split("/")[0] in OUR_FOLDERS and "/" in header:
        return header
    for program in PROGRAMS:
        if within(path, program) and "/" in header and f"{program}/{header.split('/')[0]}" in ALLOWED:
            return f"{program}/{header}"
    beside = posixpath.normpath(posixpath.join(posixpath.dirname(path), header))
    if (ROOT / beside).is_file():
        return re.sub(r"^(src|include)/", "", beside)
    return None


def violation(path, quote, header):
    """Why this file may not include this header, or None."""
    layer = layer_of(path)
    if layer is None:
        return None
    target = own_target(path, header)
    if target is None:
        places = next((THIRD_PARTY[key] for key in THIRD_PARTY if within(header, key)), None)
        if places is not None:
            may = any(within(path, place) for place in places)
            return None if may else f"only {', '.join(places)} may"
        if layer in STANDARD_ONLY and (quote == '"' or "/" in header or "." in header) and header not in OF_C:
            return f"{layer} includes nothing but itself and the standard library"
        return None
    if within(target, "tests") and layer != "tests":
        return "production code never includes tests"
    if within(target, folder_name(layer)):
        return crossing(path, target)
    allowed = ALLOWED[layer]
    if "*" in allowed or any(within(target, name) for name in allowed):
        return None
    return f"{layer} may include {', '.join(allowed) or 'nothing'}"


def crossing(path, target):
    """Why two parts of a folder with independent parts may not include each other, or None."""
    for parent in APART:
        parts = target.split("/")
        if within(path, parent) and len(parts) > 2:
            own = path[len(parent) + 1:].split("/")[0]
            if parts[1] not in (own, "products"):
                return "a pass never includes another pass; they meet through passes/products"
    return None


def check(path, text):
    findings = []
    for match in INCLUDE.finditer(text):
        reason = violation(path, match[1], match[2])
        if reason:
            line = text.count("\n", 0, match.start()) + 1
            findings.append(f"{path}:{line}: includes {match[2]}: {reason}")
    return findings


def main():
    findings = []
    for path in tracked_files():
        if path.endswith(SOURCE):
            findings += check(path, read_text(ROOT / path))
    finish("layers", findings)


if __name__ == "__main__":
    sys.exit(main())
