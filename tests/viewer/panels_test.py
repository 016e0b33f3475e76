"""Every panel by mouse: what is changed there changes the picture, and only as much as it should."""

import unittest

from driver import WindowTest
from program import CUBE_OBJ


def difference(a, b):
    """Mean over pixels and channels, in steps of 255."""
    total = sum(abs(x - y) for row, other in zip(a, b) for p, q in zip(row, other) for x, y in zip(p[:3], q[:3]))
    return total / (3 * len(a) * len(a[0]))


def brightness(picture):
    return sum(sum(pixel[:3]) for row in picture for pixel in row) / (3 * len(picture) * len(picture[0]))


class Panels(WindowTest):
    def setUp(self):
        super().setUp()
        self.write("cube.obj", CUBE_OBJ)
        self.window = self.view("cube.obj", "--transport", "dipole", "--shadow-size", "256", "--size", "1000x760")

    def tearDown(self):
        self.window.close()

    def changes(self, act):
        before = self.window.picture()
        act()
        return difference(before, self.window.picture())

    def test_medium(self):
        window = self.window
        self.assertGreater(self.changes(lambda: window.click("Medium/jade")), .5)
        place = window.place("Medium/red##absorption")
        before = window.picture()
        window.drag(place, (place[0] + 60, place[1]))
        self.assertGreater(difference(before, window.picture()), .2)
        size = window.place("Medium/size")
        before = window.picture()
        window.drag((size[0] - 30, size[1]), (size[0] - 70, size[1]))
        self.assertGreater(difference(before, window.picture()), .5, "a small body is another")

    def test_light(self):
        window = self.window
        window.only("Light")
        window.click("Light/directional 1")
        before = window.picture()
        place = window.place("Light/turn")
        window.drag(place, (place[0] + 40, place[1]))
        self.assertGreater(difference(before, window.picture()), .5)
        before = brightness(window.picture())
        window.click("Light/delete")
        self.assertLess(brightness(window.picture()), before - 1)
        self.assertNotIn("Light/directional 2", window.state()["controls"])
        window.click("Light/add point")
        self.assertIn("Light/point 1", window.state()["controls"])
        self.assertIn("Light/intensity", window.state()["controls"])

    def test_handles(self):
        """A light's handle is dragged; the camera stays."""
        window = self.window
        window.only("Light")
        before = window.picture()
        x, y, width, height = window.state()["picture"]
        fill = self.find_handle(before)
        window.drag(fill, (x + width * .5, y + height * .9))
        after = window.picture()
        self.assertGreater(difference(before, after), .5)
        self.assertIn("Light/delete", window.state()["controls"], "the light is selected")

    def find_handle(self, picture):
        """The disc of the second light, before the body: cool white, far from the body at the left."""
        hits = [(x, y) for y, row in enumerate(picture) for x, pixel in enumerate(row[:len(row) // 2])
                if pixel[2] > 250 and pixel[0] > 200 and pixel[2] > pixel[0]]
        self.assertTrue(hits)
        return (sum(x for x, _ in hits) / len(hits), sum(y for _, y in hits) / len(hits))

    def test_method(self):
        window = self.window
        window.only("Method")
        self.assertGreater(self.changes(lambda: window.choose("Method/transport", "better-dipole")), .05)
        window.choose("Method/sum", "pattern")
        self.assertIn("Method/near rings", window.state()["controls"])
        window.choose("Method/transport", "boundary")
        self.assertIn("Method/bounces", window.state()["controls"])
        self.assertNotIn("Method/near rings", window.state()["controls"], "the pattern is not for boundary transport")

    def test_divider(self):
        window = self.window
        window.only("Method")
        window.key("h")
        own = window.picture()
        window.click("Method/compare with the paper")
        x, y, width, height = window.state()["picture"]
        right = window.picture()
        half = slice(width // 2 + 60, width)
        top = slice(0, height - 60)
        self.assertEqual([row[half] for row in own[top]], [row[half] for row in right[top]])
        self.assertGreater(difference([row[:width // 2 - 20] for row in own[top]],
                                      [row[:width // 2 - 20] for row in right[top]]), .01)
        window.drag((x + width / 2, y + height / 4), (x + width - 4, y + height / 4))
        paper = window.picture()
        self.assertGreater(difference([row[half] for row in own[top]], [row[half] for row in paper[top]]), .01)

    def test_motion(self):
        window = self.window
        window.only("Motion")
        window.click("Motion/add a deformation")
        before = window.picture()
        place = window.place("Motion/amount")
        window.drag(place, (place[0] + 50, place[1]))
        window.drag(window.place("Motion/time"), (window.place("Motion/time")[0] + 30, place[1]))
        self.assertGreater(difference(before, window.picture()), .2)
        window.click("Motion/remove")
        self.assertNotIn("Motion/amount", window.state()["controls"])

    def test_playback(self):
        window = self.window
        window.only("Motion")
        window.click("Motion/add a deformation")
        frames = window.state()["frames"]
        window.xdotool("key", "space")
        window.wait_for(lambda: window.state()["frames"] > frames + 5, "it does not play")
        window.xdotool("key", "space")
        window.settle()

    def test_view(self):
        window = self.window
        window.only("View")
        before = brightness(window.picture())
        window.key("o")
        window.key("o")
        self.assertGreater(brightness(window.picture()), before + 1)
        for variable in ("exitance", "irradiance", "position", "normal", "depth", "evaluations", "object", "surfels",
                         "tree levels", "map: position", "map: normal", "map: irradiance", "map: area"):
            with self.subTest(variable):
                self.assertGreater(self.changes(lambda v=variable: window.choose("View/variable", v)), .05)

    def test_surfels(self):
        window = self.window
        window.only("View")
        self.assertNotIn("View/level", window.state()["controls"])
        window.choose("View/variable", "tree levels")
        place = window.place("View/level")
        self.assertGreater(self.changes(lambda: window.drag(place, (place[0] + 60, place[1]))), .5)
        window.only("Method")
        window.choose("Method/transport", "boundary")
        window.only("View")
        self.assertGreater(self.changes(lambda: window.choose("View/variable", "boundary surfels")), .5)
        window.only("Method")
        window.choose("Method/sum", "pattern")
        window.only("View")
        window.click("View/variable")
        self.assertIn("View/variable/object", window.state()["controls"])
        self.assertNotIn("View/variable/surfels", window.state()["controls"], "the pattern has none")

    def test_time(self):
        window = self.window
        window.only("Time")
        self.assertIn("Time/stacks", window.state()["controls"])

    def test_camera(self):
        window = self.window
        window.key("h")
        before = window.picture()
        x, y = window.middle()
        window.drag((x, y), (x + 120, y))
        turned = window.picture()
        self.assertGreater(difference(before, turned), 1)
        window.drag((x, y), (x - 120, y))
        self.assertLess(difference(before, window.picture()), .2, "and back")
        window.xdotool("click", "--repeat", 3, 4)
        window.settle()
        self.assertGreater(difference(before, window.picture()), 1)
        window.key("f")

    def test_keys(self):
        window = self.window
        self.assertGreater(self.changes(lambda: window.key("question")), .5)
        self.assertGreater(self.changes(lambda: window.key("Escape")), .5)
        width = window.state()["picture"][2]
        window.key("Tab")
        self.assertGreater(window.state()["picture"][2], width)
        window.key("Tab")


if __name__ == "__main__":
    unittest.main()
