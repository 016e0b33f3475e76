"""Frames are arrays of the right shape that show what the program shows, bit by bit."""

import gc
import os
import pathlib
import resource
import struct
import subprocess
import tempfile
import threading
import unittest
import zlib

import numpy as np
from bodies import CORNERS, scene, small

import opaline


class Frames(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.renderer = opaline.Renderer(scene())

    def test_shapes(self):
        frame = small(self.renderer, "radiance", "exitance", "normal")
        self.assertEqual(list(frame), ["radiance", "exitance", "normal"])
        for picture in frame.values():
            self.assertEqual((picture.shape, picture.dtype), ((16, 24, 4), np.float32))
        covered = frame["normal"][..., 3] > 0
        np.testing.assert_allclose(np.linalg.norm(frame["normal"][..., :3][covered], axis=1), 1, atol=1e-3)
        self.assertEqual(frame.facts["transport"], "dipole")

    def test_the_top_row_is_the_upper_one(self):
        picture = small(self.renderer, "position")["position"]
        rows = np.flatnonzero((picture[..., 3] > 0).any(axis=1))
        self.assertGreater(picture[rows[0], ..., 1].max(), picture[rows[-1], ..., 1].max())

    def test_frames_keep_their_pictures(self):
        first = small(self.renderer)["position"]
        copy = first.copy()
        self.renderer.set_positions(0, CORNERS / 2)
        second = small(self.renderer)["position"]
        self.renderer.restore_positions(0)
        np.testing.assert_array_equal(first, copy)
        self.assertFalse(np.array_equal(first, second))

    def test_options_that_make_no_sense(self):
        for wrong in ({"tolerance": 2}, {"tolerance": float("nan")}, {"transport": "magic"}, {"antialias": 3}, {"bounces": -1}):
            with self.subTest(wrong), self.assertRaises(opaline.UsageError):
                small(self.renderer, **wrong)
        for wrong in ({"quality": 2}, {"tolerance": "much"}, {"specular": 1}, {"bounces": 1.5}):
            with self.subTest(wrong), self.assertRaises(TypeError):
                small(self.renderer, **wrong)
        for wrong in ((0, 16, "radiance"), (16, 20000, "radiance"), (16, 16, "magic"), (16, 16, ["exitance", "magic"])):
            with self.subTest(wrong), self.assertRaises(opaline.UsageError):
                self.renderer.render(*wrong)

    def test_clips_that_there_are_not(self):
        for clip in (1, 2**40, -2**70, "walk"):
            with self.subTest(clip), self.assertRaisesRegex(opaline.UsageError, f"(?i)there is no clip '?{clip}"):
                self.renderer.set_time(0, clip)
        for clip in (1.5, [0], b"walk"):
            with self.subTest(clip), self.assertRaises(TypeError):
                self.renderer.set_time(0, clip)
        with self.assertRaises(opaline.UsageError):
            self.renderer.set_time(float("nan"))
        self.renderer.set_time(0)

    def test_a_notebook_shows_them(self):
        frame = small(self.renderer, "radiance")
        data = frame._repr_png_()
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", data[16:24]), (24, 16))
        length, = struct.unpack(">I", data[33:37])
        rows = np.frombuffer(zlib.decompress(data[41:41 + length]), np.uint8).reshape(16, 1 + 4 * 24)
        np.testing.assert_array_equal(rows[:, 1:].reshape(16, 24, 4), frame.tone_mapped())

    def test_files(self):
        frame = small(self.renderer, "exitance")
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "exitance.exr")
            frame.save(file)
            np.testing.assert_array_equal(opaline.read_image(file), frame["exitance"])
            frame.save(file.with_suffix(".png"))
            self.assertGreater(file.with_suffix(".png").stat().st_size, 100)
            with self.assertRaises(opaline.UsageError):
                frame.save("exitance.bmp")
            with self.assertRaises(opaline.Error):
                opaline.read_image(pathlib.Path(folder, "nothing.exr"))

    @unittest.skipUnless(os.environ.get("OPALINE"), "this build has no program")
    def test_the_program_draws_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "scene.toml")
            file.write_text('model = "builtin:teapot"\nmedium = "jade"\n[camera]\nposition_mm = [0, 0, 100]\n'
                            'target_mm = [0, 0, 0]\n[[lights]]\ntype = "directional"\ndirection_to_light = [0.6, 0, -0.8]\n'
                            'irradiance = [6, 6, 5]\n')
            made = opaline.load(file)
            for name in ("radiance", "exitance"):
                picture = pathlib.Path(folder, f"{name}.exr")
                subprocess.run([os.environ["OPALINE"], "render", file, "--size", "64x48", "--max-surfels", "8192", "--max-clusters",
                                "1024", "--aov", name, "--quiet", "-o", picture], check=True)
                ours = opaline.Renderer(made).render(64, 48, name, max_surfels=8192, max_clusters=1024)[name]
                np.testing.assert_array_equal(ours, opaline.read_image(picture))

    def test_threads_share_a_renderer(self):
        expected = small(self.renderer)["position"]
        pictures, errors = [], []

        def draw():
            try:
                pictures.append(small(self.renderer)["position"])
            except BaseException as error:
                errors.append(error)

        threads = [threading.Thread(target=draw) for _ in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(errors, [])
        for picture in pictures:
            np.testing.assert_array_equal(picture, expected)

    def test_a_thousand_frames_without_growth(self):
        teapot = opaline.teapot()
        positions = teapot.objects[0].positions_mm
        renderer = opaline.Renderer(teapot)

        def frames(count):
            for i in range(count):
                renderer.set_positions(0, positions * (1 + .1 * (i % 3)))
                renderer.render(32, 32, transport="dipole", max_surfels=1024, antialias=1)
            gc.collect()
            return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

        before = frames(200)
        # KiB. If each frame left its picture they would be 16,000, if it left its positions 13,000.
        self.assertLess(frames(1000) - before, 4096)

    def test_advice_names_keywords(self):
        renderer = opaline.Renderer(scene())
        with self.assertLogs("opaline") as logged:
            renderer.render(8, 8, transport="boundary", max_clusters=64)
        self.assertTrue(any("max_clusters" in line for line in logged.output), logged.output)
        self.assertFalse(any("::" in line for line in logged.output), logged.output)


class Comparing(unittest.TestCase):
    def test_is_the_formula(self):
        a, b = np.random.default_rng(1).random((2, 5, 7, 3))
        found = opaline.compare(a, b)
        mean = np.abs(b).mean()
        self.assertAlmostEqual(found["rel_rmse"], np.sqrt(((a - b)**2).mean()) / mean, places=5)
        self.assertAlmostEqual(found["rel_bias"], (a - b).mean() / mean, places=5)
        self.assertAlmostEqual(found["max_abs"], np.abs(a - b).max(), places=5)
        self.assertEqual(found["covered_pixels"], 35)

    def test_masks(self):
        a, b = np.zeros((4, 4, 4)), np.ones((4, 4, 4))
        a[..., 3] = 1
        a[0, 0] = 1
        mask = np.zeros((4, 4), bool)
        mask[0, 0] = True
        self.assertEqual(opaline.compare(a, b, mask)["max_abs"], 0)
        self.assertEqual(opaline.compare(a, b)["max_abs"], 1)
        broken = b.copy()
        broken[2, 1, 0] = np.nan
        for wrong in ((a, broken), (a, b[:3]), (a, b, mask[:2]), (a, b, np.zeros((4, 4))), (a[..., :2], b), (a[0], b)):
            with self.assertRaises(opaline.UsageError):
                opaline.compare(*wrong)
        with self.assertRaisesRegex(opaline.UsageError, "the second picture has a pixel"):
            opaline.compare(a, broken)
        with self.assertRaisesRegex(opaline.UsageError, "No pixel is covered by both pictures."):
            opaline.compare(np.zeros((4, 4, 4)), b)

    def test_tone(self):
        grey = np.full((2, 3, 4), .18, np.float32)
        grey[..., 3] = 1
        encoded = round(255 * (1.055 * .18**(1 / 2.4) - .055))  # IEC 61966-2-1
        self.assertEqual(opaline.tone_map(grey, curve="none")[0, 0].tolist(), [encoded] * 3 + [255])
        self.assertEqual(opaline.tone_map(grey[..., :3] / 2, 1, "none")[0, 0].tolist(), [encoded] * 3 + [255])
        with self.assertRaises(opaline.UsageError):
            opaline.tone_map(grey, curve="sepia")


if __name__ == "__main__":
    unittest.main()
