"""Numbered meshes in the window: shown, played, pulled at, filmed and saved as `render` has them."""

import unittest

from driver import BACKGROUND, CORNERS, WindowTest
from program import CUBE_OBJ

# With a camera that is placed: the window sees all of the row, and a still of one file what it shows.
PLAIN = (*CORNERS, "--no-specular", "--camera-target", "0,0,0")


def stretched(by):
    lines = CUBE_OBJ.splitlines()
    moved = [f"v {x} {float(y) * by} {z}" for kind, x, y, z in (line.split() for line in lines if line.startswith("v "))]
    return "\n".join(moved + [line for line in lines if not line.startswith("v ")]) + "\n"


class Sequence(WindowTest):
    def setUp(self):
        super().setUp()
        for number, by in ((8, 1), (9, 1.4), (10, .6)):
            self.write(f"m_{number:02}.obj", stretched(by))

    def test_all_that_a_window_does(self):
        window = self.view("m_%02d.obj", *PLAIN, "--time", 1 / 30, "--size", "900x480")
        window.key("h")
        second = window.picture()
        self.assertLessEqual(second.worst(self.rendered(window, "m_%02d.obj", *PLAIN, *BACKGROUND, "--time", 1 / 30)), 1)

        window.only("Motion")
        x, y, width, height = window.state()["controls"]["Motion/time"]
        window.drag((x + width / 3, y + height / 2), (x + width - 2, y + height / 2))
        window.move((5, 5))
        window.settle()
        third = window.picture()
        self.assertLessEqual(third.worst(self.rendered(window, "m_%02d.obj", *PLAIN, *BACKGROUND, "--time", 2 / 30)), 1)
        self.assertGreater(second.difference(third), 1)

        middle_x, middle_y = window.middle()
        frames = window.state()["frames"]
        window.move((middle_x, middle_y))
        window.use(2, "keydown", "ctrl", "mousedown", 1)
        for step in range(1, 9):
            window.move((middle_x + 10 * step, middle_y))
        window.wait_for(lambda: window.state()["frames"] > frames + 5, "it does not move")
        self.assertGreater(third.difference(window.shown()), .5)
        window.use(2, "mouseup", 1, "keyup", "ctrl")
        window.settle()
        window.move((5, 5))
        window.settle()
        self.assertLess(third.difference(window.picture()), .05, "back where its file has it")

        window.only("Save")
        window.save_as("scene")
        window.wait_for(lambda: window.state()["message"] == "saved m.toml", "not saved")
        self.assertLessEqual(third.worst(self.rendered(window, "m.toml")), 1)
        window.save_as("film")
        window.wait_for(lambda: window.state()["message"] == "saved m.mp4", "no film")
        frames = window.state()["frames"]
        window.use(2, "key", "space")
        window.wait_for(lambda: window.state()["frames"] > frames + 5, "it does not play")
        window.use(2, "key", "space")
        window.settle()
        window.close()

        again = self.view("m.toml", "--size", "900x480")
        again.move((5, 5))
        self.assertLessEqual(again.picture().worst(third), 1)
        again.close()

    def test_a_file_that_does_not_fit(self):
        self.write("m_10.obj", stretched(1).replace("f 4//6 1//6 5//6 8//6\n", ""))
        window = self.view("m_%02d.obj", *PLAIN, "--time", 2 / 30, "--size", "480x320")
        self.assertIn("m_10.obj", window.state()["message"])
        window.close()


if __name__ == "__main__":
    unittest.main()
