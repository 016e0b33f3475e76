"""No file is lost: existing files are not replaced unless named, inputs are not overwritten, and pictures tell what
made them."""

import json
import subprocess
import threading
import unittest

from images import note_of_exr, note_of_png, read_png
from program import CUBE_OBJ, PROGRAM, ProgramTest

QUICK = ("--size", "16x16", "--shadow-size", 64, "--transport", "dipole", "--max-surfels", 1024)
TEAPOT = ("render", "--builtin", "teapot", *QUICK)


class DefaultNames(ProgramTest):
    def bytes_of(self, name):
        return (self.folder / name).read_bytes()

    def test_what_is_there_stays(self):
        self.write("teapot.png", "a picture of a teapot")
        run = self.succeed(*TEAPOT, "--json")
        self.assertIn("wrote teapot-2.png, because teapot.png exists", run.err)
        self.assertEqual(run.json()["outputs"], ["teapot-2.png"])
        self.succeed(*TEAPOT)
        self.assertEqual(self.listing(), ["teapot-2.png", "teapot-3.png", "teapot.png"])
        self.assertEqual(self.bytes_of("teapot.png"), b"a picture of a teapot")
        self.assertEqual(self.bytes_of("teapot-2.png"), self.bytes_of("teapot-3.png"))

    def test_what_is_named_is_replaced(self):
        self.write("teapot.png", "an older picture")
        run = self.succeed(*TEAPOT, "-o", "teapot.png")
        self.assertIn("wrote teapot.png,", run.err)
        self.assertEqual(read_png(self.bytes_of("teapot.png")).width, 16)

    def test_rows_move_on_together(self):
        film = (*TEAPOT, "--deform", "wobble:0.1", "--frames")
        self.write("teapot_0002.png", "one of an older row")
        self.succeed(*film, "0:1")
        self.succeed(*film, "1:2")
        self.succeed(*film, "1:2")
        self.assertEqual(self.listing(), ["teapot-2_0001.png", "teapot-2_0002.png", "teapot-3_0001.png",
                                          "teapot-3_0002.png", "teapot_0000.png", "teapot_0001.png",
                                          "teapot_0002.png"])
        self.assertEqual(self.bytes_of("teapot_0002.png"), b"one of an older row")

    def test_the_reference_too(self):
        self.write("teapot.exr", "mine too")
        run = self.succeed("reference", "--builtin", "teapot", "--integral", "--size", "4x4", "--aov", "normal",
                           "--json")
        self.assertEqual(run.json()["outputs"], ["teapot-2.exr"])
        self.assertEqual(self.bytes_of("teapot.exr"), b"mine too")

    def test_two_programs_at_once(self):
        statuses = []

        def render():
            done = subprocess.run([PROGRAM, *map(str, TEAPOT)], cwd=self.folder, capture_output=True, timeout=300)
            statuses.append(done.returncode)
        threads = [threading.Thread(target=render) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(statuses, [0, 0, 0])
        self.assertEqual(self.listing(), ["teapot-2.png", "teapot-3.png", "teapot.png"])


class Inputs(ProgramTest):
    def test_what_is_read_is_not_written_over(self):
        self.write("cube.mtl", "newmtl wood\nmap_Kd -s 1 1 1 wood grain.png\nmap_Bump bump.png\n")
        self.write("other.mtl", "newmtl clay\nmap_Kd clay.png\n")
        self.write("clay.png", "one more")
        self.write("cube.obj", "\ufeffmtllib other.mtl cube.mtl\n" + CUBE_OBJ)
        self.write("cube.toml", 'model = "cube.obj"\n')
        self.write("wood grain.png", "a texture")
        self.write("bump.png", "another")
        (self.folder / "link.png").symlink_to("bump.png")
        self.succeed(*TEAPOT, "-o", "sky.exr")
        for scene in ("cube.obj", "cube.toml"):
            for name in ("wood grain.png", "bump.png", "link.png", "clay.png"):
                with self.subTest(scene=scene, name=name):
                    self.refused(2, "render", scene, *QUICK, "-o", name, says=(f"-o {name}", "is read"))
                    self.refused(2, "info", scene, "--atlas", name, says=(f"--atlas {name}", "is read"))
        self.refused(2, "render", "cube.obj", *QUICK, "--environment", "sky.exr", "-o", "sky.exr",
                     says=("-o sky.exr", "is read"))
        self.refused(2, "reference", "cube.obj", "--path", "--environment", "sky.exr", "-o", "sky.exr",
                     says="-o sky.exr")
        self.refused(2, "reference", "cube.toml", "--path", "--checkpoint", "cube.toml", says="--checkpoint cube.toml")
        self.assertEqual((self.folder / "bump.png").read_text(), "another")

    def test_frames_and_textures_of_a_gltf(self):
        self.succeed(*TEAPOT, "-o", "a.png")
        self.write("cube.gltf", json.dumps({
            "asset": {"version": "2.0"}, "images": [{"uri": "wood%201.png"}], "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                           "min": [0, 0, 0], "max": [1, 1, 0]}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}],
            "buffers": [{"byteLength": 36, "uri": "corners.bin"}]}))
        corners = b"".join(bytes(4) if not value else b"\0\0\x80\x3f" for value in (0, 0, 0, 1, 0, 0, 1, 1, 0))
        self.write("corners.bin", corners)
        self.write("wood 1.png", "a texture")
        self.refused(2, "render", "cube.gltf", *QUICK, "--frames", "0:1", "-o", "wood %d.png", says="wood 1.png")
        self.assertEqual((self.folder / "wood 1.png").read_text(), "a texture")

    def test_a_heat_map_is_no_input(self):
        self.succeed(*TEAPOT, "-o", "a.png")
        self.succeed(*TEAPOT, "-o", "b.png")
        self.refused(2, "compare", "a.png", "b.png", "--heatmap", "b.png", says=("--heatmap b.png", "is read"))


class SeveralScenes(ProgramTest):
    def test_they_are_one_scene(self):
        self.write("a.obj", CUBE_OBJ)
        self.write("b.obj", CUBE_OBJ.replace("v 1 ", "v 2 ").replace("v 0 ", "v 1 "))  # beside it
        facts = self.succeed("info", "a.obj", "b.obj", "--diagonal-mm", 30, "--json").json()
        self.assertEqual(facts["components"], 2)
        self.assertEqual(len(facts["objects"]), 2)
        size = [b - a for a, b in zip(facts["bounds_min_mm"], facts["bounds_max_mm"])]
        self.assertAlmostEqual(sum(x * x for x in size), 900, delta=1e-2)
        self.write("c.toml", "[[models]]\nfile = 'a.obj'\n[[models]]\nfile = 'b.obj'\ntranslation_mm = [80, 0, 0]\n")
        facts = self.succeed("info", "c.toml", "--json").json()
        self.assertAlmostEqual(facts["bounds_max_mm"][0], 80 + 2 * 50 / 3 ** .5, delta=1e-3)
        self.refused(2, "info", "a.obj", "c.toml", says=("c.toml", "[[models]]"))
        self.refused(2, "info", "a.obj", "b.obj", "--morph-to", "a.obj", says="--morph-to")
        self.refused(2, "compare", "a.png", "b.png", "c.png", says="one too many")


class Stamps(ProgramTest):
    FILM = ("--frames", "0:2", "--fps", 4)
    WOBBLE = ("--deform", "wobble:0.1")

    def times(self, kind):
        return [(self.folder / f"f{i}.{kind}").stat().st_mtime_ns for i in range(3)]

    def test_what_decides_the_pixels_is_noticed(self):
        # A camera that nobody placed is fitted to the moments shown.
        film = (*TEAPOT, *self.WOBBLE, "--frames", "0:2", "--camera-target", "0,0,0", "-o", "f%d.png")
        self.succeed(*film, "--fps", 4)
        # Each run continues with what the previous one left.
        for change in [("--medium", "jade"), ("--directional", "1,0,0"), ("--fov-degrees", 31), ("--tolerance", 0.02),
                       ("--diagonal-mm", 49), ("--roughness", 0.3), ("--exposure", 1)]:
            with self.subTest(change=change):
                before = self.times("png")
                run = self.succeed(*film, "--fps", 4, *change, "--resume")
                self.assertIn("3 of 3 frames came from another scene or other options", run.err)
                self.assertTrue(all(a != b for a, b in zip(before, self.times("png"))))
        # That of time 0 too, so that `film` finds one rate in all stamps.
        run = self.succeed(*film, "--fps", 5, *change, "--resume")
        self.assertIn("3 of 3 frames came from another scene", run.err)

    def test_the_device_makes_no_other_picture(self):
        film = (*TEAPOT, *self.WOBBLE, *self.FILM, "-o", "f%d.exr")
        self.succeed(*film)
        before = self.times("exr")
        run = self.succeed(*film, "--resume", "--device", 0)
        self.assertIn("3 of 3 frames existed already", run.err)
        self.assertEqual(self.times("exr"), before)

    def test_content_of_files_counts_and_their_names_do_not(self):
        self.write("a.obj", CUBE_OBJ)
        self.succeed("render", "a.obj", *QUICK, *self.FILM, "-o", "f%d.png")
        self.write("a.obj", CUBE_OBJ.replace("v 1 1 1", "v 1 1 2"))
        run = self.succeed("render", "a.obj", *QUICK, *self.FILM, "-o", "f%d.png", "--resume")
        self.assertIn("3 of 3 frames came from another scene", run.err)

    def test_a_picture_without_a_stamp_is_made_anew(self):
        self.succeed(*TEAPOT, "-o", "f1.png")
        run = self.succeed(*TEAPOT, *self.WOBBLE, *self.FILM, "-o", "f%d.png", "--resume")
        self.assertIn("1 of 3 frames came from another scene", run.err)
        self.assertIn("wrote 3 frames", run.err)

    def test_others_can_read_it(self):
        for kind, read in (("png", note_of_png), ("exr", note_of_exr)):
            self.succeed(*TEAPOT, "--medium", "jade", *self.FILM, "-o", f"f%d.{kind}")
            stamp = json.loads(read((self.folder / f"f2.{kind}").read_bytes()))
            self.assertEqual(stamp["seconds"], 0.5)
            self.assertEqual(stamp["size"], [16, 16])
            self.assertEqual(stamp["transport"], "dipole")
            self.assertEqual(stamp["media"][0]["medium"], "jade")
            self.assertRegex(stamp["digest"], "^[0-9a-f]{16}$")

    def test_a_row_is_named_to_go_on_with_it(self):
        self.refused(2, *TEAPOT, *self.FILM, "--resume", says=("--resume", "-o frame_%04d.png"))


if __name__ == "__main__":
    unittest.main()
