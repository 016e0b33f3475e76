"""What the window shows is what `render` draws."""

import unittest

from driver import WindowTest
from images import read_png
from program import CUBE_OBJ

# The window's own, where none is asked for.
BACKGROUND = ("--background", "0.03,0.03,0.035")


class Picture(WindowTest):
    def setUp(self):
        super().setUp()
        self.write("cube.obj", CUBE_OBJ)

    def rendered(self, window, *arguments):
        _, _, width, height = window.state()["picture"]
        self.succeed("render", *arguments, "--size", f"{width}x{height}", "--quiet", "-o", "rendered.png")
        return read_png((self.folder / "rendered.png").read_bytes()).rows

    def same(self, shown, rendered):
        """Two roundings of one value: at most a step apart."""
        self.assertEqual((len(shown), len(shown[0])), (len(rendered), len(rendered[0])))
        worst = max(abs(a - b) for row, other in zip(shown, rendered) for p, q in zip(row, other)
                    for a, b in zip(p[:3], q[:3]))
        self.assertLessEqual(worst, 1)
        self.assertGreater(len({pixel for row in shown for pixel in row}), 100, "there is something to see")

    def check(self, *arguments):
        window = self.view(*arguments, "--size", "800x500")
        window.key("h")
        self.same(window.picture(), self.rendered(window, *arguments, *BACKGROUND))
        return window

    def test_the_default_method(self):
        self.check("--builtin", "teapot", "--medium", "skin1").close()

    def test_the_paper(self):
        self.check("cube.obj", "--method", "paper", "--medium", "marble", "--dsm-size", "128", "--point", "20,30,20:900,900,800",
                   "--ambient", ".3,.2,.1").close()

    def test_tone_and_no_reflection(self):
        self.check("cube.obj", "--transport", "better-dipole", "--exposure", "1.5", "--tone", "none", "--no-specular",
                   "--antialias", "8").close()

    def test_motion_and_camera(self):
        self.check("cube.obj", "--transport", "dipole", "--deform", "twist:0.6", "--time", "1.25", "--camera-direction", "1,.5,2",
                   "--fov-degrees", "40").close()

    def test_a_saved_picture_is_the_same(self):
        window = self.view("cube.obj", "--transport", "dipole", "--size", "640x400")
        window.key("h")
        window.drag((100, 100), (180, 60))
        shown = window.picture()
        window.click("save picture")
        self.same(shown, read_png((self.folder / "cube.png").read_bytes()).rows)
        window.close()


if __name__ == "__main__":
    unittest.main()
