"""Every command of README.md and docs/ runs in a fresh folder and leaves the files that it names; every option
mentioned is in a help. Small stand-ins replace models and the built-in bear, and pictures are small."""

import json
import math
import os
import struct
import unittest

import documents
from program import COMMANDS, ProgramTest

NEEDS_A_DISPLAY = "display"
MODELS = ("bunny.ply", "bunny_closed.ply", "bunny_egg_a.ply", "bunny_egg_b.ply", "duck.ply", "ball.ply")
ENVIRONMENTS = ("venice_sunset_1k.hdr",)
ANIMATED = ("walker.glb", "CesiumMan.glb", "models/duck.glb", "materials/CandleTable.glb")


def ball(across=1.0):
    """An octahedron whose triangles are divided three times, on a sphere: vertices and triangles."""
    corners = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    triangles = [(x, y, z) if (x + y + z) % 2 == 0 else (x, z, y) for x in (0, 1) for y in (2, 3) for z in (4, 5)]
    between = {}

    def middle(a, b):
        key = min(a, b), max(a, b)
        if key not in between:
            sums = [p + q for p, q in zip(corners[a], corners[b])]
            corners.append(tuple(s / math.hypot(*sums) for s in sums))
            between[key] = len(corners) - 1
        return between[key]

    for _ in range(3):
        divided = []
        for a, b, c in triangles:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            divided += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = divided
    return [(across * x, y, z) for x, y, z in corners], triangles


def ply(across=1.0):
    corners, triangles = ball(across)
    return (f"ply\nformat ascii 1.0\nelement vertex {len(corners)}\nproperty float x\nproperty float y\nproperty float z\n"
            f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
            + "".join("%g %g %g\n" % corner for corner in corners)
            + "".join("3 %d %d %d\n" % triangle for triangle in triangles))


def sky_hdr():
    """Radiance 1 from the upper half, a quarter from the lower."""
    return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n" + 4 * b"\x80\x80\x80\x81" + 4 * b"\x80\x80\x80\x7f"


def walking_glb():
    """The ball of 5 cm, moved to the side and back by a clip named walk."""
    corners, triangles = ball()
    scaled = [tuple(.025 * x for x in corner) for corner in corners]
    times, places = (0, 1, 2), ((0, 0, 0), (.01, 0, 0), (0, 0, 0))
    parts = [struct.pack("<%df" % (3 * len(scaled)), *(x for corner in scaled for x in corner)),
             struct.pack("<%dI" % (3 * len(triangles)), *(i for triangle in triangles for i in triangle)),
             struct.pack("<3f", *times), struct.pack("<9f", *(x for place in places for x in place))]
    views, offset = [], 0
    for part in parts:
        views.append({"buffer": 0, "byteOffset": offset, "byteLength": len(part)})
        offset += len(part)
    least = [min(corner[axis] for corner in scaled) for axis in range(3)]
    most = [max(corner[axis] for corner in scaled) for axis in range(3)]
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "animations": [{"name": "walk", "samplers": [{"input": 2, "output": 3}],
                        "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(scaled), "type": "VEC3", "min": least, "max": most},
                      {"bufferView": 1, "componentType": 5125, "count": 3 * len(triangles), "type": "SCALAR"},
                      {"bufferView": 2, "componentType": 5126, "count": 3, "type": "SCALAR", "min": [0], "max": [2]},
                      {"bufferView": 3, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": views, "buffers": [{"byteLength": offset}]}).encode()
    text += b" " * (-len(text) % 4)
    binary = b"".join(parts)
    return (b"glTF" + struct.pack("<II", 2, 28 + len(text) + len(binary)) + struct.pack("<I", len(text)) + b"JSON" + text
            + struct.pack("<I", len(binary)) + b"BIN\0" + binary)


def given(words, option):
    return words[words.index(option) + 1] if option in words else None


def with_value(words, option, value):
    """The same words with the option set to this value, whether it was there or not."""
    if option in words:
        at = words.index(option)
        return words[:at + 1] + [value] + words[at + 2:]
    return words + [option, value]


def made_cheap(words):
    """The same command on a smaller body with fewer pixels, surfels, frames and seconds."""
    command = words[1]
    scene = len(words) > 2 and not words[2].startswith("-") or any(
        word.endswith((".ply", ".glb", ".toml")) for word in words[2:])
    if "--help" in words:
        return words
    if "--diagonal-mm" in words or command == "bench":
        words = with_value(words, "--diagonal-mm", "5")
    if command in ("render", "reference", "info") and not scene:
        words = words[:2] + ["ball.ply"] + words[2:]
    if command in ("render", "reference"):
        words = with_value(words, "--size", "16x16")
        if "-o" not in words:
            words = words + ["-o", "variable.exr" if "--aov" in words else "still.png"]
    if command == "render":
        if "pattern" not in words and "paper" not in words:
            words = with_value(words, "--max-surfels", "4096")
        if "--aov" not in words:
            words = with_value(words, "--antialias", "1")
        if "--chunk" in words:
            words = with_value(words, "--chunk", "1/1")
    if "--frames" in words and command in ("render", "reference", "film"):
        words = with_value(words, "--frames", "0:1")
    if "--path" in words:
        words = with_value(words, "--seconds", "0.2")
    if command == "bench":
        words = with_value(with_value(words, "--size", "16"), "--frames", "1")
        if words[2] == "methods" and "--truth" not in words:
            words = with_value(words, "--seconds", "0.2")
        if words[2] == "scaling":
            words = with_value(words, "--max-surfels", "16384")
        if not scene or len(words) > 3 and words[3].startswith("-"):
            words = words[:3] + ["ball.ply"] + words[3:]
    return words


def outputs(words):
    """The files that a command writes."""
    names = [given(words, option) for option in ("-o", "--heatmap", "--plot", "--atlas", "--report")]
    for name in filter(None, names):
        yield from [name % frame for frame in (0, 1)] if "%" in name else [name]


class Documents(ProgramTest):
    def setUp(self):
        super().setUp()
        for name in ("models", "frames"):
            (self.folder / name).mkdir()
        for name in MODELS:
            self.write(name, ply(1.2 if name == "bunny_egg_b.ply" else 1.0))
        for name in ENVIRONMENTS:
            self.write(name, sky_hdr())
        (self.folder / "materials").mkdir()
        for name in ANIMATED:
            self.write(name, walking_glb())

    def run_page(self, page):
        found = documents.commands(documents.pages()[page])
        self.assertTrue(found, page)
        for words in found:
            with self.subTest(page=page, command=" ".join(words)):
                if words[1] == "view":
                    # The command line is accepted here; tests/viewer opens windows.
                    here = {name: value for name, value in os.environ.items() if "DISPLAY" not in name}
                    self.refused(1, *words[1:], says=NEEDS_A_DISPLAY, env=here)
                    continue
                cheap = made_cheap(words)
                before = {name: (self.folder / name).stat().st_mtime_ns for name in outputs(cheap)
                          if (self.folder / name).exists()}
                self.succeed(*cheap[1:])
                for name in outputs(cheap):
                    path = self.folder / name
                    self.assertGreater(path.stat().st_size, 0, name)
                    self.assertNotEqual(path.stat().st_mtime_ns, before.get(name), name)

    def test_scene_files(self):
        self.succeed("render", "ball.ply", "--size", "16x8", "--aov", "radiance", "-o", "sky.exr")
        shown = 0
        for page, text in documents.pages().items():
            for block in documents.blocks(text, "toml"):
                with self.subTest(page=page, scene=block):
                    self.write("scene.toml", block)
                    self.succeed("info", "scene.toml")
                    shown += 1
        self.assertGreater(shown, 0)

    def test_every_option_is_in_a_help(self):
        helps = {command: documents.options(self.succeed(command, "--help").out) | {"--help"} for command in COMMANDS}
        of_others = {"--preset", "--build", "--install", "--prefix", "--cflags", "--libs", "--static",
                     "--system-site-packages", "--chunks", "--rounds", "--sbatch", "--ssh", "--partition",
                     "--gres", "--library"}  # CMake, pkg-config, venv, opaline-film, sbatch, install-dependencies.sh
        anywhere = set().union(*helps.values()) | {"--version"} | of_others
        for page, text in documents.pages().items():
            self.assertEqual(documents.options(text) - anywhere, set(), page)
            for words in documents.commands(text):
                self.assertEqual(documents.options(" ".join(words)) - helps[words[1]], set(), (page, words))


def add_a_test_of_each_page():
    for page, text in documents.pages().items():
        if documents.commands(text):
            name = page.removesuffix(".md").removeprefix("docs/").replace("-", "_").lower()
            setattr(Documents, f"test_{name}", lambda self, page=page: self.run_page(page))


add_a_test_of_each_page()

if __name__ == "__main__":
    unittest.main()
