"""Files that are chosen in the window, edits that are taken back, and what is asked before work is lost."""

import os
import unittest

from driver import CORNERS, WindowTest
from images import read_png
from program import CUBE_OBJ

TALL_OBJ = "\n".join(line.replace(" 1 ", " 2 ") if line.startswith("v ") else line for line in CUBE_OBJ.splitlines()) + "\n"

# As quick as CORNERS, of a medium in which light is scattered thousands of times: nobody waits for its truth.
SCENE_TOML = """model = "tall.obj"
diagonal_mm = 100
medium = "wholemilk"
[render]
transport = "dipole"
site = "vertex"
antialias = 1
max_surfels = 4096
tolerance = 0.1
shadow_size = 256
"""


class Dialogs(WindowTest):
    def setUp(self):
        super().setUp()
        self.work = self.folder / "work"
        self.work.mkdir()
        (self.work / "cube.obj").write_text(CUBE_OBJ, encoding="utf-8")
        inner = self.work / "inner ü"
        inner.mkdir()
        (inner / "tall.obj").write_text(TALL_OBJ, encoding="utf-8")
        (inner / "two\nlines.toml").write_text(SCENE_TOML, encoding="utf-8")
        (inner / "notes.txt").write_text("", encoding="utf-8")

    def listed(self, window):
        return {name[len("File/"):] for name in window.state()["controls"] if name.startswith("File/")}

    def await_listed(self, window, name):
        window.wait_for(lambda: name in self.listed(window), f"no {name} among {self.listed(window)}")

    def await_message(self, window, text):
        window.wait_for(lambda: window.state()["message"] == text, f"not {text}")
        window.settle()

    def await_name(self, window, name):
        window.wait_for(lambda: window.title() == f"{name} - Opaline", f"{name} was not opened")
        window.settle()

    def test_the_windows_own_dialog(self):
        """One window: opened, edited, undone, saved, asked, left."""
        window = self.view("cube.obj", *CORNERS, "--size", "760x600",
                           folder=self.work)
        for part in (self.opened, self.undone, self.saved, self.set_by_hand, self.asked):
            with self.subTest(part.__name__):
                part(window)
        window.await_end()
        # Where a file was opened from is where the next one is looked for.
        again = self.view("cube.obj", *CORNERS, "--size", "640x480", folder=self.work)
        again.key("ctrl+o")
        self.await_listed(again, "tall.obj")
        again.key("Escape")
        again.close()

    def opened(self, window):
        window.key("ctrl+o")
        self.await_listed(window, "inner ü/")
        self.assertIn("cube.obj", self.listed(window))
        # What is typed is a name, and no key of the window.
        window.use(8, "type", "nope")
        window.key("Return")
        self.assertIn("name", self.listed(window), "it stays open")
        window.click("File/inner ü/")
        window.key("Return")
        self.await_listed(window, "tall.obj")
        self.assertIn("two?lines.toml", self.listed(window))
        self.assertNotIn("notes.txt", self.listed(window))
        window.click("File/all files")
        self.await_listed(window, "notes.txt")
        window.click("File/all files")
        window.click("File/parent")
        self.await_listed(window, "cube.obj")
        window.key("Escape")
        self.assertEqual(self.listed(window), set())
        # By keys alone: the folder, then the second of its files, whose name cannot be typed.
        window.key("ctrl+o")
        self.await_listed(window, "inner ü/")
        window.key("Down")
        window.key("Return")
        self.await_listed(window, "tall.obj")
        window.key("Down")
        window.key("Down")
        window.key("Return")
        self.await_name(window, "two lines")

    def undone(self, window):
        window.only("Medium")
        window.move((5, 5))
        window.settle()
        plain = window.picture()
        window.click("Medium/jade")
        window.move((5, 5))
        window.settle()
        jade = window.picture()
        self.assertGreater(plain.difference(jade), .1)
        place = window.place("Medium/red##absorption")
        window.drag((place[0] - 20, place[1]), (place[0] + 60, place[1]))
        window.key("ctrl+z")
        window.move((5, 5))
        window.settle()
        self.assertEqual(window.picture().data, jade.data, "a drag is one step")
        window.key("ctrl+z")
        self.assertEqual(window.picture().data, plain.data)
        window.key("ctrl+z")
        self.assertEqual(window.picture().data, plain.data, "there is nothing before")
        window.key("ctrl+shift+z")
        self.assertEqual(window.picture().data, jade.data)
        # The size is loaded anew, and comes back all the same.
        size = window.place("Medium/size")
        window.drag((size[0] - 30, size[1]), (size[0] - 60, size[1]))
        window.move((5, 5))
        window.settle()
        self.assertGreater(jade.difference(window.picture()), .1)
        window.click("undo")
        window.move((5, 5))
        window.settle()
        self.assertLess(jade.difference(window.picture()), .02)

    def saved(self, window):
        window.only("Save")
        window.click("Save/picture...")
        self.await_listed(window, "name")
        window.use(6, "type", "out")  # in place of the name that is offered
        window.key("Return")
        self.await_message(window, "saved out.png")
        file = self.work / "out.png"
        file.write_bytes(b"precious")
        window.click("Save/picture...")
        self.await_listed(window, "name")
        window.key("Return")  # the name of the last one is offered
        self.await_listed(window, "replace")
        self.assertEqual(file.read_bytes(), b"precious")
        window.key("Escape")
        self.assertIn("save", self.listed(window), "another name may be chosen")
        window.key("Return")
        window.click("File/replace")
        self.await_message(window, "saved out.png")
        self.assertNotEqual(file.read_bytes(), b"precious")

    def set_by_hand(self, window):
        """Size and background of what is saved."""
        window.only("Save")
        window.choose("Save/size", "1024 x 1024")
        width = window.state()["picture"][2:]
        self.assertEqual(width[0], width[1], "the window shows what is saved")
        window.click("Save/width")
        window.use(2, "key", "ctrl+a")
        window.use(4, "type", "64")
        window.key("Return")
        window.click("Save/height")
        window.use(2, "key", "ctrl+a")
        window.use(4, "type", "32")
        window.key("Return")
        window.key("p")
        window.wait_for(lambda: window.state()["message"].startswith("saved "), "not saved")
        name = window.state()["message"].split()[1].rstrip(",")
        picture = read_png((self.work / name).read_bytes())
        self.assertEqual((picture.width, picture.height), (64, 32))
        window.choose("Save/size", "as in the window")
        # What does not move is not played.
        frames = window.state()["frames"]
        window.key("space")
        self.assertIn("moves by itself", window.state()["message"])
        self.assertEqual(window.state()["frames"], frames)

    def asked(self, window):
        """Before a truth that is under way, or a film, is lost."""
        window.only("Truth")
        window.press("Truth/path tracing")
        window.wait_for(lambda: "Truth/cancel" in window.state()["controls"], "no truth is under way")
        self.stays_when_asked(window, "Truth/cancel")
        window.use(2, "key", "ctrl+o")
        self.await_listed(window, "name")
        window.use(2, "type", "tw")
        window.use(2, "key", "Down")
        window.use(2, "key", "Return")
        window.wait_for(lambda: "Question/stop and open" in window.state()["controls"], "nothing was asked")
        window.press("Question/stop and open")
        window.wait_for(lambda: "Truth/cancel" not in window.state()["controls"], "the truth goes on")
        window.settle()

        window.only("Save")
        window.click("Save/the motion once")
        window.click("Save/last frame")
        window.use(2, "key", "ctrl+a")
        window.use(10, "type", "99999")
        window.key("Return")
        window.click("Save/film...")
        self.await_listed(window, "name")
        window.use(2, "key", "Return")
        window.wait_for(lambda: "Save/stop the film" in window.state()["controls"], "no film is under way")
        self.stays_when_asked(window, "Save/stop the film")
        window.xdotool("key", "ctrl+q")
        window.wait_for(lambda: "Question/stop and leave" in window.state()["controls"], "nothing was asked")
        window.xdotool("key", "Return")

    def stays_when_asked(self, window, sign):
        window.use(2, "key", "ctrl+q")
        window.wait_for(lambda: "Question/go on" in window.state()["controls"], "nothing was asked")
        window.press("Question/go on")
        window.wait_for(lambda: "Question/go on" not in window.state()["controls"], "the question stays")
        self.assertIsNone(window.process.poll())
        self.assertIn(sign, window.state()["controls"], "it goes on")

    def test_where_nothing_can_be_written(self):
        """That is not where later files go."""
        window = self.view("cube.obj", *CORNERS, "--size", "760x600", folder=self.work)
        window.only("Save")
        window.click("Save/picture...")
        self.await_listed(window, "name")
        window.use(20, "type", "/proc/none")
        window.key("Return")
        window.wait_for(lambda: "/proc/none.png" in window.state()["message"], "nothing was said of it")
        window.settle()
        window.key("p")
        self.await_message(window, "saved cube.png")
        window.close()

    def test_the_desktops_dialog(self):
        """A program in its place notes what it was asked, and answers with a name of two lines."""
        programs = self.folder / "programs"
        programs.mkdir()
        chosen = self.work / "inner ü" / "two\nlines.toml"
        (programs / "zenity").write_text(
            '#!/bin/sh\nprintf "%s\\n" "$@" > "$NOTES"\nwhile [ ! -e "$NOTES.go" ]; do sleep .05; done\nprintf "%s\\n" "$CHOSEN"\n',
            encoding="utf-8")
        (programs / "zenity").chmod(0o755)
        notes = self.folder / "notes"
        window = self.view("cube.obj", *CORNERS, "--size", "480x320", folder=self.work, environment={
            "PATH": f"{programs}:{os.environ['PATH']}", "XDG_CURRENT_DESKTOP": "GNOME", "NOTES": str(notes), "CHOSEN": str(chosen)})
        window.use(2, "key", "ctrl+o")
        window.wait_for(notes.exists, "no dialog was opened")
        # The window lives on meanwhile.
        before = window.picture()
        window.key("Right")
        window.drag((100, 100), (160, 100))
        self.assertGreater(before.difference(window.picture()), .5)
        self.assertIn("another window", window.state()["message"])
        self.assertIn(f"--filename={self.work}/", notes.read_text(encoding="utf-8").splitlines())
        (self.folder / "notes.go").touch()
        self.await_name(window, "two lines")
        window.close()


if __name__ == "__main__":
    unittest.main()
