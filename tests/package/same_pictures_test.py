"""The same scene gives the same picture, bit by bit, on the command line, in C++, C and Python."""

import base64
import json
import math
import os
import struct
import unittest
import zlib

from installed import ROOT, Installed, cached


def png(rows):
    """A picture of RGB bytes."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", len(rows[0]) // 3, len(rows), 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(b"".join(b"\0" + bytes(row) for row in rows)))
            + chunk(b"IEND", b""))


def sky():
    """A Radiance picture of 16 x 8 pixels: blue above, dark below, with a lamp."""
    pixels = b"".join(bytes((60, 90, 140 - 12 * y, 128)) if (x, y) != (5, 2) else bytes((255, 240, 200, 133))
                      for y in range(8) for x in range(16))
    return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n" + pixels


class Gltf:
    """A ball with a texture that a clip squashes and a textured plate that it turns; what light enters is the ball."""

    def __init__(self):
        self.data, self.views, self.accessors = b"", [], []

    def add(self, values, kind, component=5126):
        flat = [value for entry in values for value in entry]
        data = struct.pack(f"<{len(flat)}{'f' if component == 5126 else 'I'}", *flat)
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)})
        self.data += data
        accessor = {"bufferView": len(self.views) - 1, "componentType": component, "count": len(values), "type": kind}
        if kind != "SCALAR" or component == 5126:
            accessor |= {"min": [min(column) for column in zip(*values)], "max": [max(column) for column in zip(*values)]}
        self.accessors.append(accessor)
        return len(self.accessors) - 1

    def ball(self, around=16, down=10):
        places = [(u / around, v / down) for v in range(down + 1) for u in range(around + 1)]
        points = [(.01 * math.sin(math.pi * v) * math.cos(2 * math.pi * u), .01 * math.cos(math.pi * v),
                   .01 * math.sin(math.pi * v) * math.sin(-2 * math.pi * u)) for u, v in places]
        corner = lambda u, v: v * (around + 1) + u
        triangles = [triangle for v in range(down) for u in range(around)
                     for triangle in ((corner(u, v), corner(u, v + 1), corner(u + 1, v + 1)), (corner(u, v), corner(u + 1, v + 1), corner(u + 1, v)))]
        return {"attributes": {"POSITION": self.add(points, "VEC3"), "TEXCOORD_0": self.add(places, "VEC2")},
                "indices": self.add([(c,) for triangle in triangles for c in triangle], "SCALAR", 5125), "material": 0,
                "targets": [{"POSITION": self.add([(.3 * x, -.4 * y, 0) for x, y, _ in points], "VEC3")}]}

    def plate(self):
        corners = [(-.02, -.012, .015), (.02, -.012, .015), (.02, -.012, -.015), (-.02, -.012, -.015)]
        return {"attributes": {"POSITION": self.add(corners, "VEC3"), "TEXCOORD_0": self.add([(0, 0), (2, 0), (2, 2), (0, 2)], "VEC2")},
                "indices": self.add([(c,) for c in (0, 1, 2, 0, 2, 3)], "SCALAR", 5125), "material": 1}

    def text(self):
        spots = png([[(60, 200, 130, 230, 120, 90)[(3 * (x + y) + c) % 6] for x in range(4) for c in range(3)] for y in range(4)])
        meshes = [{"primitives": [self.ball()], "weights": [0]}, {"primitives": [self.plate()]}]
        times = self.add([(0,), (2,)], "SCALAR")
        weights, turns = self.add([(0,), (1,)], "SCALAR"), self.add([(0, 0, 0, 1), (0, math.sqrt(.5), 0, math.sqrt(.5))], "VEC4")
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()
        texture = {"baseColorTexture": {"index": 0}}
        return json.dumps({
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
            "nodes": [{"mesh": 0, "name": "ball"}, {"mesh": 1, "name": "plate"}], "meshes": meshes, "accessors": self.accessors,
            "bufferViews": self.views, "buffers": [{"uri": uri, "byteLength": len(self.data)}],
            "images": [{"uri": "data:image/png;base64," + base64.b64encode(spots).decode()}], "textures": [{"source": 0}],
            "materials": [{"name": "wax", "pbrMetallicRoughness": texture, "extras": {"mean_free_path_mm": [1.5, 1, .6]}},
                          {"name": "tin", "pbrMetallicRoughness": texture | {"metallicFactor": .6, "roughnessFactor": .4}}],
            "animations": [{"name": "all", "samplers": [{"input": times, "output": weights}, {"input": times, "output": turns}],
                            "channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}},
                                         {"sampler": 1, "target": {"node": 1, "path": "rotation"}}]}]})


SCENE = """model = "{}"
[environment]
file = "sky.hdr"
rotation_degrees = 40
[[lights]]
type = "directional"
direction_to_light = [0.45, 0.35, -0.82]
irradiance = [3, 3, 2.5]
[camera]
position_mm = [10, 25, 70]
target_mm = [0, 0, 0]
"""

PYTHON = """import sys, opaline
scene, seconds, site, *files = sys.argv[1:]
renderer = opaline.Renderer(opaline.load(scene))
renderer.set_time(float(seconds))
frame = renderer.render(96, 64, ["radiance", "exitance"], site=site, max_surfels=8192, max_clusters=1024)
for file, name in zip(files, frame):
    frame.save(file, name)
"""


class SamePictures(Installed):
    def test_the_same_picture_in_every_language(self):
        pictures = {}
        for language in ("cpp", "c"):
            program = self.built_examples(language) / "still"
            files = [program.parent / name for name in ("still.png", "radiance.exr", "exitance.exr")]
            self.assertIn("exitance in the middle", self.run_example(program, *files))
            pictures[language] = [path.read_bytes() for path in files]
        self.assertEqual(pictures["cpp"], pictures["c"])
        program = self.prefix / "bin" / "opaline"
        if not program.exists():
            return
        ours = self.folder / "radiance.exr"
        self.succeed(program, "render", "--medium", "jade", "--size", "320x320", "--directional", "0.6,0,-0.8:6,6,5",
                     "--directional", "0,1,0:0.5,0.5,0.6", "--ambient", "0.05,0.05,0.05", "--aov", "radiance", "-o", ours)
        theirs = self.built_examples("cpp") / "radiance.exr"
        self.assertEqual(json.loads(self.succeed(program, "compare", ours, theirs, "--json"))["max_abs"], 0)

    def test_of_a_file_at_a_time(self):
        scene = self.folder / "scene.toml"
        scene.with_name("body.gltf").write_text(Gltf().text())
        scene.with_name("sky.hdr").write_bytes(sky())
        scene.write_text(SCENE.format("body.gltf"))
        programs = self.built(ROOT / "tests" / "package" / "drawn_file")

        def drawn(language, seconds, site):
            files = [self.folder / f"{language}_{seconds}_{site}_{name}.exr" for name in ("radiance", "exitance")]
            if language == "python":
                folder, = (self.prefix / "lib").glob("python3*/site-packages")
                self.succeed(cached("OPALINE_PYTHON_EXECUTABLE"), "-c", PYTHON, scene, seconds, site, *files,
                             env=os.environ | {"PYTHONPATH": str(folder)})
            else:
                self.run_example(programs / f"draw_{language}", scene, seconds, site, *files)
            return files

        def contents(files):
            return [file.read_bytes() for file in files]

        # Where light leaves is chosen for each body, or found at each pixel: by boundary transport both.
        moved = {site: drawn("cpp", 1.3, site) for site in ("auto", "fragment")}
        program = self.prefix / "bin" / "opaline"
        for site, files in moved.items():
            with self.subTest(site=site):
                self.assertEqual(contents(files), contents(drawn("c", 1.3, site)))
                if cached("OPALINE_BUILD_PYTHON") == "ON":
                    self.assertEqual(contents(files), contents(drawn("python", 1.3, site)))
                if program.exists():
                    ours = self.folder / f"program_{site}.exr"
                    self.succeed(program, "render", scene, "--time", 1.3, "--size", "96x64", "--site", site, "--max-surfels", "8192",
                                 "--max-clusters", "1024", "--aov", "radiance", "-o", ours, "--quiet")
                    self.assertEqual(json.loads(self.succeed(program, "compare", ours, files[0], "--json"))["max_abs"], 0)
        for now, still in zip(contents(moved["auto"]), contents(drawn("cpp", 0, "auto"))):
            self.assertNotEqual(now, still, "the clip moves them")


if __name__ == "__main__":
    unittest.main()
