"""Scenes that are wrong get one sentence that names the file, quickly and without much memory. What
each loader refuses is tested beside the loaders; here the whole program is."""

import resource
import unittest

from program import CUBE_OBJ, ProgramTest
from wrong_scenes import WRONG, gltf

LARGEST_MEMORY_KB = 500 * 1000


class WrongScenes(ProgramTest):
    def test_each_is_refused_by_name(self):
        self.write("cube.obj", CUBE_OBJ)
        for name, content in WRONG.items():
            self.write(name, content)
        before = self.listing()
        for name in WRONG:
            for command in ("info", "render"):
                with self.subTest(name=name, command=command):
                    says = "lost.obj" if name == "lost.toml" else "" if name == "utf8.toml" else name
                    self.refused(1, command, name, "--quiet", says=says)
        self.assertEqual(self.listing(), before)
        self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, LARGEST_MEMORY_KB)

    def test_a_right_one_like_the_wrong_ones_is_read(self):
        self.write("right.gltf", gltf())
        self.assertEqual(self.succeed("info", "right.gltf", "--json").json()["triangles"], 1)

    def test_an_unknown_key_names_its_neighbour(self):
        self.write("cube.obj", CUBE_OBJ)
        self.write("key.toml", WRONG["key.toml"])
        self.refused(1, "info", "key.toml", says=("diagonal", "diagonal_mm"))

    def test_a_ball_has_an_observed_color(self):
        self.write("cube.obj", CUBE_OBJ)
        self.write("ball.toml", 'model = "cube.obj"\n[materials.a]\nkind = "translucent"\nball_mm = 5\nmean_free_path_mm = 1\n')
        self.succeed("info", "ball.toml", "--quiet")
        self.refused(1, "info", "ball.toml", "--color-model", "khr", "--quiet", says=("ball.toml", "ball_mm", "color_model"))

    def test_what_is_no_file(self):
        (self.folder / "folder.ply").mkdir()
        self.refused(1, "info", "nosuch.ply", says="nosuch.ply")
        self.refused(1, "info", "folder.ply", says="folder.ply")
        self.refused(1, "info", "/dev/zero", says="/dev/zero")
        self.refused(1, "info", "", says="")
        self.refused(1, "info", "line\nbreak.ply", says="line?break.ply")

    def test_an_environment_that_is_wrong(self):
        self.write("empty.hdr", b"")
        self.write("text.exr", b"this is no EXR")
        self.write("promise.hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 900000000 +X 900000000\n")
        for name in ("empty.hdr", "text.exr", "promise.hdr", "nosuch.hdr"):
            self.refused(1, "render", "--environment", name, "--quiet", says=name)


if __name__ == "__main__":
    unittest.main()
