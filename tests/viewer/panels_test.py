"""Every panel by mouse: what is changed there changes the picture, and only as much as it should."""

import re
import unittest

from driver import COARSE, CORNERS, Shot, WindowTest
from images import read_png
from program import CUBE_OBJ


class Panels(WindowTest):
    def test_every_panel(self):
        """In one window, one after the other, as they stand after each other."""
        self.window = self.view("--builtin", "teapot", "--medium", "gummy-red", *CORNERS, "--size", "760x600")
        for part in (self.handles, self.camera, self.keys, self.divider, self.method, self.time, self.motion, self.quick, self.playback,
                     self.poke, self.show, self.film, self.numbers, self.typing, self.medium, self.material, self.light, self.from_above,
                     self.ground, self.many_lights):
            with self.subTest(part.__name__):
                part()
        self.window.close()

    def changes(self, act):
        before = self.window.picture()
        act()
        return before.difference(self.window.picture())

    def medium(self):
        window = self.window
        window.only("Medium")
        self.assertGreater(self.changes(lambda: window.click("Medium/jade")), .5)
        place = window.place("Medium/red##absorption")
        before = window.picture()
        window.drag(place, (place[0] + 60, place[1]))
        self.assertGreater(before.difference(window.picture()), .2)
        size = window.place("Medium/size")
        before = window.picture()
        window.drag((size[0] - 30, size[1]), (size[0] - 70, size[1]))
        self.assertGreater(before.difference(window.picture()), .5, "a small body is another")

    def material(self):
        """Of the translucent teapot: by appearance, and its reflection."""
        window = self.window
        window.only("Material")
        for control in ("mean free path, red", "roughness"):
            place = window.place(f"Material/{control}")
            before = window.picture()
            window.drag((place[0] - 20, place[1]), (place[0] + 50, place[1]))
            self.assertGreater(before.difference(window.picture()), .05, control)

    def light(self):
        window = self.window
        window.only("Light")
        window.click("Light/directional 1")
        before = window.picture()
        place = window.place("Light/turn")
        window.drag(place, (place[0] + 40, place[1]))
        self.assertGreater(before.difference(window.picture()), .5)
        before = window.picture().brightness()
        window.click("Light/delete")
        self.assertLess(window.picture().brightness(), before - 1)
        self.assertNotIn("Light/directional 2", window.state()["controls"])
        window.click("Light/add point")
        self.assertIn("Light/point 1", window.state()["controls"])
        self.assertIn("Light/intensity", window.state()["controls"])
        window.click("Light/add spot")
        self.assertIn("Light/spot 1", window.state()["controls"])
        before = window.picture()
        place = window.place("Light/outer angle")
        window.drag((place[0] - 20, place[1]), (place[0] - 60, place[1]))
        self.assertGreater(before.difference(window.picture()), .01, "a narrow cone is another light")
        window.click("Light/delete")
        self.assertNotIn("Light/spot 1", window.state()["controls"])
        for shape in ("rectangle", "tube"):
            before = window.picture()
            window.click(f"Light/add {shape}")
            self.assertIn(f"Light/{shape} 1", window.state()["controls"])
            self.assertIn("Light/radiance", window.state()["controls"])
            self.assertGreater(before.difference(window.picture()), .3, shape)
            window.click("Light/delete")
            self.assertNotIn(f"Light/{shape} 1", window.state()["controls"])

    def from_above(self):
        """The height of a disc is where it shines from, as that of all lights; a second click on a button adds a second light."""
        window = self.window
        window.only("Light")
        button = window.place("Light/add disc")
        window.click(button)
        window.click(button)
        self.assertIn("Light/disc 2", window.state()["controls"])
        window.click("Light/delete")
        window.click("Light/disc 1")
        place = window.place("Light/height")
        window.drag(place, (place[0] + 400, place[1]))
        window.key("s")
        (saved,) = self.folder.glob("*.toml")
        normal = re.search(r"normal = \[(.*)\]", saved.read_text(encoding="utf-8"))[1].split(",")
        self.assertLess(float(normal[1]), -.99, "it shines down")
        saved.unlink()
        window.click("Light/delete")

    def ground(self):
        """Put under the scene, coloured, taken back and saved."""
        window = self.window
        window.only("Light")
        self.assertGreater(self.changes(lambda: window.click("Light/ground")), .3)
        window.key("c")
        self.assertIn("lights no ground", window.state()["message"])
        self.assertIn("Light/color of the ground", window.state()["controls"])
        place = window.place("Light/height of the ground")
        lowered = window.picture()
        window.drag(place, (place[0] - 30, place[1]))
        self.assertGreater(lowered.difference(window.picture()), .1, "a lower one is another")
        window.key("s")
        saved = next(self.folder.glob("*.toml")).read_text(encoding="utf-8")
        self.assertIn("[ground]", saved)
        window.key("ctrl+z")
        window.key("ctrl+z")
        self.assertNotIn("Light/color of the ground", window.state()["controls"])

    def handles(self):
        """A light's handle is dragged; the camera stays."""
        window = self.window
        window.only("Light")
        before = window.picture()
        x, y, width, height = window.state()["picture"]
        fill = self.find_handle(before)
        window.drag(fill, (x + width * .5, y + height * .9))
        after = window.picture()
        self.assertGreater(before.difference(after), .5)
        self.assertIn("Light/delete", window.state()["controls"], "the light is selected")
        window.key("h")

    def find_handle(self, picture):
        """The disc of the second light, before the body: cool white, far from the body at the left."""
        left = picture.part(right=picture.width // 2)
        hits = [(i % left.width, i // left.width) for i, pixel in enumerate(left.pixels())
                if pixel[2] > 250 and pixel[0] > 200 and pixel[2] > pixel[0]]
        self.assertTrue(hits)
        return (sum(x for x, _ in hits) / len(hits), sum(y for _, y in hits) / len(hits))

    def method(self):
        window = self.window
        window.only("Method")
        self.assertGreater(self.changes(lambda: window.choose("Method/transport", "better-dipole")), .05)
        window.choose("Method/sum", "pattern")
        self.assertIn("Method/near rings", window.state()["controls"])
        window.choose("Method/transport", "boundary")
        self.assertIn("Method/bounces", window.state()["controls"])
        self.assertNotIn("Method/near rings", window.state()["controls"], "the pattern is not for boundary transport")

    def divider(self):
        window = self.window
        window.only("Method")
        own = window.picture()
        window.click("Method/compare with the paper")
        x, y, width, height = window.state()["picture"]
        right = window.picture()
        middle, bottom = width // 2, height - 60
        self.assertEqual(own.part(left=middle + 60, bottom=bottom).data, right.part(left=middle + 60, bottom=bottom).data)
        left = own.part(right=middle - 20, bottom=bottom)
        self.assertGreater(left.difference(right.part(right=middle - 20, bottom=bottom)), .01)
        window.drag((x + middle, y + height / 4), (x + width - 4, y + height / 4))
        paper = window.picture().part(left=middle + 60, right=width - 20, bottom=bottom)
        self.assertGreater(paper.difference(own.part(left=middle + 60, right=width - 20, bottom=bottom)), .01)
        window.key("c")

    def motion(self):
        window = self.window
        window.only("Motion")
        window.click("Motion/add a deformation")
        before = window.picture()
        place = window.place("Motion/amount")
        window.drag(place, (place[0] + 50, place[1]))
        window.drag(window.place("Motion/time"), (window.place("Motion/time")[0] + 30, place[1]))
        self.assertGreater(before.difference(window.picture()), .2)
        window.click("Motion/remove")
        self.assertNotIn("Motion/amount", window.state()["controls"])

    def quick(self):
        """What follows is of any transport."""
        window = self.window
        window.only("Method")
        window.choose("Method/transport", "dipole")

    def playback(self):
        window = self.window
        window.only("Motion")
        window.click("Motion/add a deformation")
        frames = window.state()["frames"]
        window.use(2, "key", "space")
        window.wait_for(lambda: window.state()["frames"] > frames + 5, "it does not play")
        window.use(2, "key", "space")
        window.settle()
        window.click("Motion/remove")

    def poke(self):
        """Pulled it gives way; let go it comes back to the very picture."""
        window = self.window
        before = window.picture()
        x, y = window.middle()
        window.move((x, y))
        window.use(2, "keydown", "ctrl", "mousedown", 1)
        frames = window.state()["frames"]
        for step in range(1, 9):
            window.move((x + 15 * step, y - 5 * step))
        window.wait_for(lambda: window.state()["frames"] > frames + 5, "it does not move")
        pulled = window.shown()
        window.use(2, "mouseup", 1, "keyup", "ctrl")
        self.assertGreater(before.difference(pulled), 1)
        window.settle()
        self.assertLess(before.difference(window.picture()), .05)

    def film(self):
        window = self.window
        window.only("Motion")
        window.click("Motion/add a deformation")
        window.only("Save")
        window.save_as("film")
        window.wait_for(lambda: window.state()["message"] == "saved teapot.mp4", "no film")
        self.assertGreater((self.folder / "teapot.mp4").stat().st_size, 1000)

    def numbers(self):
        """Of a film's frames, in their order."""
        window = self.window
        window.settle()
        window.only("Save")
        window.click("Save/the motion once")
        for control, typed in (("first frame", "1e2"), ("last frame", "7"), ("last frame", "1/2")):
            window.click(f"Save/{control}")
            window.use(2, "key", "ctrl+a")
            window.use(2 * len(typed), "type", typed)
            window.key("Return")
        window.click("Save/film...")
        window.wait_for(lambda: "File/name" in window.state()["controls"], "no file can be chosen")
        window.use(6, "type", "one")
        window.use(2, "key", "Return")
        window.wait_for(lambda: window.state()["message"] == "saved one.mp4", "no film of one frame")
        window.settle()
        window.choose("Save/size", "1024 x 1024")
        window.click("Save/width")
        window.use(2, "key", "ctrl+a")
        window.use(4, "type", "33")
        window.key("Return")
        window.click("Save/film...")
        window.wait_for(lambda: "File/name" in window.state()["controls"], "no file can be chosen")
        window.use(6, "type", "odd")
        window.use(2, "key", "Return")
        window.wait_for(lambda: window.state()["message"].startswith("saved odd.mp4, 32x1024 pixels"), "no film of an odd width")
        window.settle()
        window.choose("Save/size", "as in the window")
        window.click("Save/the motion once")

    def typing(self):
        """What is typed is a name, and no key of the window."""
        window = self.window
        window.only("Save")
        window.key("Escape")  # what the window last said goes
        window.move((5, 5))
        window.settle()
        picture, area = window.picture(), window.state()["picture"]
        window.click("Save/picture...")
        window.wait_for(lambda: "File/name" in window.state()["controls"], "no file can be chosen")
        window.use(22, "type", "pshotcf?x 1")
        window.key("Left")
        window.key("Escape")
        window.move((5, 5))
        window.settle()
        self.assertEqual(window.picture().data, picture.data)
        self.assertEqual(window.state()["picture"], area)
        self.assertEqual([path.name for path in self.folder.glob("*.toml")], [])

    def many_lights(self):
        """As many as there are shadow maps for, and no more."""
        window = self.window
        window.only("Light")
        for _ in range(9):
            window.click("Light/add point")
        lights = [name for name in window.state()["controls"] if name.startswith("Light/point ")]
        # A map for each of six sides, of 48 in all; one is of the light from afar.
        self.assertEqual(len(lights), 7)

    def show(self):
        window = self.window
        window.only("View")
        before = window.picture().brightness()
        window.key("o")
        window.key("o")
        self.assertGreater(window.picture().brightness(), before + 1)
        for variable in ("exitance", "irradiance", "position", "normal", "depth", "evaluations", "object", "map: position",
                         "map: normal", "map: irradiance", "map: area", "surfels", "tree levels"):
            with self.subTest(variable):
                self.assertGreater(self.changes(lambda v=variable: window.choose("View/variable", v)), .05)
        # A map is not seen by the camera, which is not moved unseen.
        window.choose("View/variable", "radiance")
        window.move((5, 5))
        before = window.picture()
        window.choose("View/variable", "map: normal")
        x, y = window.middle()
        window.drag((x, y), (x + 90, y))
        self.assertIn("does not see the map", window.state()["message"])
        window.key("Escape")
        window.choose("View/variable", "radiance")
        window.move((5, 5))
        self.assertLess(before.difference(window.picture()), .05)
        window.choose("View/variable", "normal")
        self.assert_saved_as_shown("normal")
        # An open list is closed by a key.
        window.click("View/variable")
        self.assertIn("View/variable/radiance", window.state()["controls"])
        window.key("Escape")
        self.assertNotIn("View/variable/radiance", window.state()["controls"])
        window.choose("View/variable", "radiance")

    def assert_saved_as_shown(self, name):
        window = self.window
        window.move((5, 5))
        window.settle()
        shown = window.picture()
        window.key("p")
        (saved,) = self.folder.glob("*.png")
        picture = Shot.of(read_png(saved.read_bytes()))
        saved.unlink()
        self.assertLess(shown.part(top=60).difference(picture.part(top=60)), .5, name)

    def time(self):
        window = self.window
        window.only("Time")
        self.assertIn("Time/stacks", window.state()["controls"])

    def camera(self):
        window = self.window
        before = window.picture()
        x, y = window.middle()
        window.drag((x, y), (x + 120, y))
        turned = window.picture()
        self.assertGreater(before.difference(turned), 1)
        window.drag((x, y), (x - 120, y))
        self.assertLess(before.difference(window.picture()), .2, "and back")
        window.use(3, "click", "--repeat", 3, 4)
        window.settle()
        self.assertGreater(before.difference(window.picture()), 1)
        window.key("f")

    def keys(self):
        window = self.window
        self.assertGreater(self.changes(lambda: window.key("question")), .5)
        self.assertGreater(self.changes(lambda: window.key("Escape")), .5)
        width = window.state()["picture"][2]
        window.key("Tab")
        self.assertGreater(window.state()["picture"][2], width)
        window.key("Tab")


class Truth(WindowTest):
    # Far away: a truth takes its time for every pixel of the body.
    SCENE = ("cube.obj", "--transport", "dipole", "--no-specular", "--antialias", "1", *COARSE, "--fov-degrees", "100",
             "--size", "360x400")

    def setUp(self):
        super().setUp()
        self.write("cube.obj", CUBE_OBJ)

    def body(self, window):
        window.move((5, 5))  # no tooltip over it
        window.settle()
        picture = window.picture()
        middle_x, middle_y = picture.width // 2, picture.height // 2
        return picture.part(middle_x - 20, middle_y - 20, middle_x + 20, middle_y + 20)

    def test_truth(self):
        window = self.view(*self.SCENE, "--diagonal-mm", "5", "--medium", "gummy-red")
        window.key("h")
        window.only("Truth")
        window.click("Truth/dipole's integral")
        window.wait_for(lambda: window.state()["truth"] == 1, "no truth")
        picture = self.body(window)
        self.assertGreater(picture.colors(), 20)
        window.choose("Truth/shown", "truth")
        truth = self.body(window)
        self.assertLess(picture.difference(truth), 3)
        self.assertNotEqual(picture.data, truth.data)
        window.choose("Truth/shown", "heat map")
        self.assertGreater(truth.difference(self.body(window)), 5)
        # Whoever turns the camera sees the picture, and its turn.
        x, y = window.middle()
        window.drag((x, y), (x + 60, y))
        self.assertGreater(picture.difference(self.body(window)), 1)
        window.drag((x, y), (x - 60, y))
        self.assertLess(picture.difference(self.body(window)), .5)
        window.close()

    def test_truth_that_is_cancelled(self):
        # Light is scattered thousands of times in it: nobody waits for that.
        window = self.view(*self.SCENE, "--diagonal-mm", "100", "--medium", "wholemilk")
        window.only("Truth")
        window.press("Truth/path tracing")
        window.wait_for(lambda: "Truth/cancel" in window.state()["controls"], "it cannot be cancelled")
        window.press("Truth/cancel")
        window.wait_for(lambda: "Truth/cancel" not in window.state()["controls"], "it goes on")
        window.close()


if __name__ == "__main__":
    unittest.main()
