"""The window itself: opening, sizes, closing, and what it costs while nothing happens."""

import json
import os
import subprocess
import time
import unittest

from driver import CORNERS, Window, WindowTest
from program import CUBE_OBJ, PROGRAM

QUICK = (*CORNERS, "--size", "480x320")


class Opening(WindowTest):
    def test_without_a_display(self):
        environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
        self.refused(1, "view", says=("display", "render"), env=environment)

    def test_the_working_folder_stays_as_it_is(self):
        work = self.folder / "work"
        work.mkdir()
        window = self.view("--builtin", "teapot", *QUICK, folder=work)
        window.key("f")
        window.close()
        self.assertEqual(list(work.iterdir()), [])
        self.assertEqual([path.name for path in (self.config / "opaline").iterdir()], ["view.json"])

    def test_it_is_found_as_it_was_left(self):
        window = self.view("--builtin", "teapot", *QUICK)
        window.click("Medium")
        window.key("h")
        window.close()
        again = self.view("--builtin", "teapot", *CORNERS)
        self.assertFalse(any(name.startswith("Medium/") for name in again.state()["controls"]))
        x, y, width, height = again.state()["picture"]
        self.assertEqual(height, 320)
        again.close()

    def test_a_state_that_makes_no_sense(self):
        (self.config / "opaline").mkdir()
        for text in ("", "{", '{"size": [-5, 1e99]}', "[]", '"' + "x" * 100000 + '"'):
            (self.config / "opaline" / "view.json").write_text(text, encoding="utf-8")
            self.view("--builtin", "teapot", *QUICK).close()

    def test_closed_while_it_loads(self):
        window = Window(self, self.display, *QUICK)
        window.wait_for(window.places.exists, "no window came")
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Opaline"], env=window.environment,
                               capture_output=True, text=True, check=True).stdout.split()
        window.xdotool("windowfocus", found[-1])
        window.close()

    def test_a_file_that_is_not_there(self):
        window = Window(self, self.display, "nothing.ply", *QUICK)
        window.wait_for(lambda: window.places.exists() and "nothing.ply" in window.state()["message"], "no message")
        self.write("cube.obj", CUBE_OBJ)
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Opaline"], env=window.environment,
                               capture_output=True, text=True, check=True).stdout.split()
        window.handle = found[-1]
        window.xdotool("windowfocus", "--sync", window.handle)
        # The error stays, and something else can be opened.
        window.press((100, 100))
        self.assertIn("nothing.ply", window.state()["message"])
        window.press("open...")
        window.wait_for(lambda: "File/name" in window.state()["controls"], "no file can be chosen")
        window.use(8, "type", "cube")
        window.use(2, "key", "Down")
        window.use(2, "key", "Return")
        window.wait_for(lambda: window.state()["frames"] > 0, "nothing was opened")
        window.settle()
        self.assertIn("Medium", window.state()["controls"])
        window.close()

    def test_wrong_arguments(self):
        self.refused(2, "view", "--medium", "granite", says="granite")
        self.refused(2, "view", "--transport", "boundary", "--sum", "pattern", says="boundary")
        self.refused(2, "view", "--frames", "0:9:3", says=("--frames A:B:STEP", "numbered pictures"))
        self.refused(2, "view", "-o", "f%d.png", says=("-o f%d.png", "render"))
        self.refused(2, "view", "-o", "a.toml", says=".png, .exr or .mp4")
        self.refused(1, "view", "-o", "none/a.png", says="none")
        self.refused(1, "view", "--report", "none/a.json", says="none")
        self.refused(2, "view", "--aov", "depht", says="did you mean depth?")
        self.refused(2, "view", "--aov", "surfels", "--sum", "pattern", says="the pattern has no surfels")


class Asked(WindowTest):
    """What the command line asks of the window."""

    def test_frames_names_and_report(self):
        (self.folder / "out").mkdir()
        window = self.view("--builtin", "teapot", *CORNERS, "--size", "900x600", "--deform", "squash:0.4:2", "--frames", "15:20", "--fps", 12.5,
                           "--time", 0.25, "-o", "out/picture.exr", "--report", "report.json")
        window.key("p")
        window.wait_for(lambda: window.state()["message"] == "saved out/picture.exr", "key P saved nothing")
        window.key("s")
        window.wait_for(lambda: window.state()["message"] == "saved out/picture.toml", "no scene was saved")
        window.only("Save")
        window.save_as("film")
        window.wait_for(lambda: window.state()["message"].endswith("out/picture.mp4"), "no film")
        window.close()
        report = json.loads((self.folder / "report.json").read_text(encoding="utf-8"))
        self.assertEqual(report["triangles"], 2256)
        said = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v", "-show_entries",
                               "stream=nb_read_frames,r_frame_rate", "-of", "json", self.folder / "out" / "picture.mp4"],
                              capture_output=True, check=True).stdout
        self.assertEqual(json.loads(said)["streams"], [{"r_frame_rate": "25/2", "nb_read_frames": "6"}])

    def test_a_variable(self):
        by_hand = self.view("--builtin", "teapot", *QUICK)
        by_hand.only("View")
        by_hand.choose("View/variable", "normal")
        by_hand.key("h")
        shown = by_hand.picture()
        by_hand.close()
        asked = self.view("--builtin", "teapot", *QUICK, "--aov", "normal")
        self.assertLess(asked.picture().difference(shown), .5)
        asked.close()


class NoRoom(WindowTest):
    def test_an_edit_that_the_device_has_no_memory_for_is_taken_back(self):
        """48 shadow maps of 64 MiB are more than it gives to one image."""
        lights = [word for x in range(8) for word in ("--point", f"{10 * x - 35},90,60:2000,2000,2000")]
        window = self.view("--builtin", "teapot", *CORNERS, "--size", "700x850", *lights)
        window.only("Light")
        before = window.picture()
        window.choose("Light/shadow map", "4096")
        self.assertIn("shadow maps", window.state()["message"])
        self.assertIn("memory", window.state()["message"])
        self.assertEqual(window.picture().part(top=100).worst(before.part(top=100)), 0)
        window.choose("Light/shadow map", "512")
        self.assertEqual(window.state()["message"], "")
        window.key("ctrl+z")
        window.key("s")
        window.wait_for((window.folder / "teapot.toml").exists, "no scene was saved")
        self.assertIn("shadow_size = 256", (window.folder / "teapot.toml").read_text(encoding="utf-8"))
        window.close()


class Sizes(WindowTest):
    def test_every_size_is_drawn(self):
        self.write("cube.obj", CUBE_OBJ)
        window = self.view("cube.obj", *CORNERS, "--size", "640x400")
        for width, height in ((900, 700), (333, 777), (320, 240), (1200, 300)):
            window.xdotool("windowsize", "--sync", window.handle, width, height)
            window.wait_for(lambda size=(width, height): self.area(window)[3] == size[1], "no new size")
            window.settle()
            shown = window.picture()
            self.assertEqual(shown.height, height)
            self.assertGreater(shown.colors(), 50, "a picture is there")
        window.close()

    def test_all_of_the_body_is_in_a_narrow_window(self):
        window = self.view("--builtin", "teapot", *CORNERS, "--size", "330x700")
        window.key("h")
        shown = window.picture()
        self.assertGreater(shown.colors(), 50)
        for x in (0, shown.width - 1):
            self.assertEqual(shown.part(left=x, right=x + 1, bottom=500).colors(), 1)
        window.close()

    def test_on_a_desktop_of_fine_pixels(self):
        """All is twice as large, but only once."""
        plain = self.view("--builtin", "teapot", *QUICK)
        x, y, width, height = plain.state()["controls"]["Medium/jade"]
        plain.close()
        subprocess.run(["xprop", "-root", "-f", "RESOURCE_MANAGER", "8s", "-set", "RESOURCE_MANAGER", "Xft.dpi:\t192\n"],
                       env=dict(os.environ, DISPLAY=self.display), check=True)
        for _ in range(2):
            window = self.view("--builtin", "teapot", *CORNERS)
            self.assertEqual(self.area(window)[3], 2 * 320)
            fine = window.state()["controls"]["Medium/jade"]
            self.assertAlmostEqual(fine[3], 2 * height, delta=2)
            self.assertAlmostEqual(fine[1], 2 * y, delta=4)
            window.click("Medium/jade")
            window.close()

    def test_out_of_sight_and_back(self):
        window = self.view("--builtin", "teapot", *QUICK)
        window.xdotool("windowunmap", "--sync", window.handle)
        time.sleep(.5)
        window.xdotool("windowmap", "--sync", window.handle)
        window.settle()
        window.xdotool("windowfocus", window.handle)
        window.close()

    @staticmethod
    def area(window):
        return window.state()["picture"]


class Response(WindowTest):
    def setUp(self):
        super().setUp()
        if self.succeed("info", "--json").json()["devices"][0]["type"] != "software":
            self.skipTest("pictures come at once")

    def assert_seen_before_a_picture(self, window, begin):
        """What `begin` asks for takes a while, in which a panel can be folded."""
        window.only("Medium")
        frames = window.state()["frames"]
        begin()
        window.press("Medium")
        window.wait_for(lambda: "Medium/marble" not in window.state()["controls"], "the click was never seen")
        self.assertEqual(window.state()["frames"], frames, "it was seen only after the picture")
        window.wait_for(lambda: window.state()["message"] == "rendering", "no sign that it is busy")
        window.settle()
        self.assertGreater(window.state()["frames"], frames)

    def test_a_click_is_seen_while_a_scene_is_prepared(self):
        """For the paper's method the first time."""
        window = self.view("--size", "480x400", "--antialias", "4")
        self.assert_seen_before_a_picture(window, lambda: window.use(2, "key", "c"))
        window.close()

    def test_a_film_is_stopped_at_once(self):
        window = self.view("--size", "760x700", "--transport", "dipole")
        window.only("Save")
        window.choose("Save/size", "3840 x 2160")
        window.save_as("film")
        window.wait_for(lambda: "Save/stop the film" in window.state()["controls"], "no film is made")
        before = self.count_drawings(window, 1)
        self.assertGreater(before, 3, "the window is drawn meanwhile")
        window.press("Save/stop the film")
        window.wait_for(lambda: window.state()["message"] == "the film was stopped", "it was not stopped")
        window.wait_for(lambda: "Save/film..." in window.state()["controls"], "another one cannot be made")
        window.choose("Save/size", "as in the window")
        window.settle()
        self.assertEqual(list(self.folder.glob("*.mp4*")), [])
        window.close()

    @staticmethod
    def count_drawings(window, seconds):
        """The times that the window was drawn meanwhile."""
        count, last, end = 0, window.places.stat().st_mtime_ns, time.monotonic() + seconds
        while time.monotonic() < end:
            now = window.places.stat().st_mtime_ns
            count, last = count + (now != last), now
            time.sleep(.01)
        return count

    def test_nothing_is_seen_while_the_last_picture_is_awaited(self):
        window = self.view("--size", "1200x900", "--antialias", "8", "--medium", "jade")
        (self.config / "opaline" / "view.json").unlink(missing_ok=True)
        window.press("Medium/marble")
        window.wait_for(lambda: window.state()["message"] == "rendering", "no sign that it is busy")
        window.xdotool("key", "ctrl+q")
        window.wait_for(lambda: not self.is_visible(window), "it stays on the screen")
        self.assertTrue((self.config / "opaline" / "view.json").exists())
        window.await_end()

    @staticmethod
    def is_visible(window):
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Opaline"], env=window.environment,
                               capture_output=True, text=True, check=False)
        return bool(found.stdout.split())

    def test_a_click_is_seen_while_the_device_works(self):
        window = self.view("--size", "640x480", "--antialias", "4", "--medium", "jade")
        self.assert_seen_before_a_picture(window, lambda: window.press("Medium/marble"))
        self.assertEqual(window.state()["message"], "")
        window.close()


class Rest(WindowTest):
    def test_nothing_moving_costs_nothing(self):
        window = self.view("--builtin", "teapot", *QUICK)
        window.settle()
        frames = window.state()["frames"]
        before, begin = self.cpu_seconds(window), time.monotonic()
        time.sleep(5)
        share = (self.cpu_seconds(window) - before) / (time.monotonic() - begin)
        self.assertLess(share, .02)
        self.assertEqual(window.state()["frames"], frames)
        window.close()


if __name__ == "__main__":
    unittest.main()
