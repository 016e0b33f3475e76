"""tools/gltf_viewer.py by numbers; and whole, where OPALINE_GLTF_VIEWER names the folder into which npm has
installed the viewers, and there is a browser."""

import contextlib
import io
import json
import os
import pathlib
import shutil
import struct
import sys
import unittest
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path += [str(ROOT / "tools"), str(ROOT / "tests" / "cli")]

import gltf_viewer

BROWSER = "chromium"


class Formulas(unittest.TestCase):
    def test_smooth_surfaces_mirror_as_schlick_says(self):
        for cosine in (0.9, 0.5):
            base, grazing = gltf_viewer.mirrored_parts(1e-3, cosine, steps=16)
            self.assertAlmostEqual(grazing, (1 - cosine) ** 5, places=3)
            self.assertAlmostEqual(base + grazing, 1, places=3)

    def test_rough_surfaces_mirror_what_a_sum_over_directions_gives(self):
        alpha, out, steps = 0.36, 0.6, 240
        total, eye = 0.0, (0.8, 0.0, 0.6)
        for i in range(steps):
            for k in range(steps):
                to_light, angle = (i + 0.5) / steps, 2 * gltf_viewer.math.pi * (k + 0.5) / steps
                side = gltf_viewer.math.sqrt(1 - to_light ** 2)
                way = (side * gltf_viewer.math.cos(angle), side * gltf_viewer.math.sin(angle), to_light)
                half = gltf_viewer.unit(tuple(a + b for a, b in zip(eye, way)))
                total += gltf_viewer.ggx(alpha, half[2], out, to_light) * to_light * 2 * gltf_viewer.math.pi / steps ** 2
        self.assertAlmostEqual(sum(gltf_viewer.mirrored_parts(alpha, out)), total, delta=0.003)

    def test_what_is_matt_gives_back_by_lambert(self):
        normal = gltf_viewer.TO_LIGHT
        plain, whole = gltf_viewer.radiance(0, 1, lambda out: (0.5, 0.0), normal, normal)
        lobe = gltf_viewer.ggx(1, 1, 1, 1)
        for color, found, added in zip(gltf_viewer.COLOR, plain, whole):
            matt = gltf_viewer.IRRADIANCE * color / gltf_viewer.math.pi
            self.assertAlmostEqual(found, 0.96 * matt + gltf_viewer.IRRADIANCE * 0.04 * lobe)
            self.assertAlmostEqual(added, (1 - 1.04 * 0.02) * matt + gltf_viewer.IRRADIANCE * 1.04 * 0.04 * lobe)


class Pictures(unittest.TestCase):
    def test_the_file_says_its_material(self):
        data = gltf_viewer.ball_file(0.5, 0.25)
        kind, version, length = struct.unpack_from("<4sII", data)
        self.assertEqual((kind, version, length), (b"glTF", 2, len(data)))
        size, = struct.unpack_from("<I", data, 12)
        material = json.loads(data[20:20 + size])["materials"][0]["pbrMetallicRoughness"]
        self.assertEqual((material["metallicFactor"], material["roughnessFactor"]), (0.5, 0.25))

    def test_each_pixel_is_of_the_longest_exposure_that_shows_it_whole(self):
        count = gltf_viewer.SIZE ** 2
        shown = {exposure: bytes((round(255 * min(1, 0.5 * exposure) ** (1 / 2.2)),) * 3 + (255,)) * count
                 for exposure in gltf_viewer.EXPOSURES}
        pixel = gltf_viewer.merged(shown).at(3, 5)
        self.assertAlmostEqual(pixel[0], 0.5, delta=0.01)

    def test_blocks_that_miss_a_pixel_do_not_count(self):
        pixels = {(x, y): (1.0, 2.0, 3.0 + x) for x in range(16) for y in range(8)}
        del pixels[9, 2]
        self.assertEqual(gltf_viewer.block_means(pixels), {(0, 0): [1, 2, 6.5]})


class Viewer(unittest.TestCase):
    def test_balls_are_those_of_the_viewers(self):
        folder, program = os.environ.get("OPALINE_GLTF_VIEWER"), os.environ.get("OPALINE")
        if not (folder and program and shutil.which(BROWSER)):
            self.skipTest("no viewer, program or browser")
        out = io.StringIO()
        with mock.patch.object(sys, "argv", ["gltf_viewer.py", folder, program]), contextlib.redirect_stdout(out):
            gltf_viewer.main()
        rows = [line.split("|")[1:-1] for line in out.getvalue().splitlines()[2:]]
        self.assertEqual(len(rows), len(gltf_viewer.METALNESSES) * len(gltf_viewer.ROUGHNESSES))
        for metallic, roughness, _, _, _, without in rows:
            self.assertLess(float(without.split(",")[0]), 5, (metallic, roughness))


if __name__ == "__main__":
    unittest.main()
