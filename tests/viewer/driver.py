"""Opens the window on a display of its own and uses mouse and keys on it."""

import json
import math
import os
import pathlib
import subprocess
import time

from images import read_png
from program import PROGRAM, ProgramTest

# Waiting for the program, on machines of any speed.
LONGEST_SECONDS = 240

# Longer than there is between the two of a double click, and nearer to each other than that.
DOUBLE_CLICK_SECONDS = .35
DOUBLE_CLICK_PIXELS = 10

# Where the sum over the body is not what is looked at.
COARSE = ("--max-surfels", "4096", "--tolerance", "0.1", "--shadow-size", "256")

# Nor how it is interpolated: light for each corner of a few faces alone.
CORNERS = ("--transport", "dipole", "--site", "vertex", "--antialias", "1", *COARSE)

# The window's own, where none is asked for.
BACKGROUND = ("--background", "0.03,0.03,0.035")


def start_display(test, size="1400x900"):
    """A display; its name."""
    return start_server(test, size)[0]


def start_server(test, size):
    """The same, and its server."""
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", f"{size}x24", "-nolisten", "tcp", "-noreset"],
                              pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    test.addCleanup(server.wait)
    test.addCleanup(server.kill)
    with os.fdopen(read) as pipe:
        return ":" + pipe.readline().strip(), server


class Shot:
    """A picture in bytes, R G B, rows from the top."""

    def __init__(self, width, height, data):
        assert len(data) == 3 * width * height, (len(data), width, height)
        self.width, self.height, self.data = width, height, data

    @staticmethod
    def of(picture):
        """A picture as read_png has it, opaque."""
        return Shot(picture.width, picture.height, bytes(value for row in picture.rows for pixel in row for value in pixel[:3]))

    def part(self, left=0, top=0, right=None, bottom=None):
        right, bottom = right or self.width, bottom or self.height
        rows = [self.data[3 * (y * self.width + left):3 * (y * self.width + right)] for y in range(top, bottom)]
        return Shot(right - left, bottom - top, b"".join(rows))

    def pixels(self):
        return zip(self.data[0::3], self.data[1::3], self.data[2::3])

    def colors(self):
        return len(set(self.pixels()))

    def brightness(self):
        return sum(self.data) / len(self.data)

    def worst(self, other):
        assert (self.width, self.height) == (other.width, other.height)
        return max(abs(a - b) for a, b in zip(self.data, other.data))

    def difference(self, other):
        """Mean over pixels and channels, in steps of 255."""
        assert (self.width, self.height) == (other.width, other.height)
        return sum(abs(a - b) for a, b in zip(self.data, other.data)) / len(self.data)


class Window:
    """`opaline view` with the validation layer on, whose messages make it fail in the end."""

    def __init__(self, test, display, *arguments, folder=None, environment=None):
        self.test = test
        self.folder = folder or test.folder
        self.places = test.folder / "controls.json"
        self.places.unlink(missing_ok=True)
        self.pressed = (0, (0, 0))
        # Where no desktop runs, the dialogs are the window's own.
        self.environment = dict(os.environ, DISPLAY=display, XDG_CONFIG_HOME=str(test.config), XDG_CURRENT_DESKTOP="")
        # Mesa 22.3 reads the list of what a scene refers to after it has freed it, which filled memory turns into a crash.
        self.environment.pop("MALLOC_PERTURB_", None)
        self.environment.update(environment or {})
        self.errors = open(test.folder / "errors.txt", "w+", encoding="utf-8")
        test.addCleanup(self.errors.close)
        self.process = subprocess.Popen(
            [PROGRAM, "view", "--validation", "--controls", str(self.places), *map(str, arguments)],
            cwd=self.folder, env=self.environment, stderr=self.errors)
        test.addCleanup(self.process.wait)
        test.addCleanup(self.process.kill)

    def wait_for(self, what, why):
        deadline = time.monotonic() + LONGEST_SECONDS
        while not what():
            self.test.assertIsNone(self.process.poll(), f"it ended: {self.said()}")
            self.test.assertLess(time.monotonic(), deadline, f"{why}: {self.state() if self.places.exists() else 'nothing was drawn'}")
            time.sleep(.02)

    def said(self):
        self.errors.seek(0)
        return self.errors.read()

    def state(self):
        return json.loads(self.places.read_bytes())

    def open(self):
        """Until the first picture stands."""
        self.wait_for(lambda: self.places.exists() and self.state()["frames"] > 0, "no picture came")
        self.settle()
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--pid", str(self.process.pid)], check=False,
                               env=self.environment, capture_output=True, text=True).stdout.split()
        if not found:
            found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Opaline"], check=True,
                                   env=self.environment, capture_output=True, text=True).stdout.split()
        self.handle = found[-1]
        self.xdotool("windowfocus", "--sync", self.handle)
        return self

    def settle(self):
        """Until nothing moves any more, and for long enough that nothing is about to."""
        since = None

        def idle():
            nonlocal since
            if not self.state()["idle"]:
                since = None
                return False
            since = since or time.monotonic()
            return time.monotonic() - since > .1
        self.wait_for(idle, "it never came to rest")

    def xdotool(self, *arguments):
        done = subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, check=False,
                              capture_output=True, text=True)
        self.test.assertEqual(done.returncode, 0, f"{arguments}: {done.stderr}; the program said: {self.said()}")

    def use(self, inputs, *arguments):
        """What xdotool does with keys and buttons, until the interface was drawn with so many inputs more."""
        before = self.state()["inputs"]
        self.xdotool(*arguments)
        self.wait_for(lambda: self.state()["inputs"] >= before + inputs, f"{arguments} never came")

    def title(self):
        """As desktops show it, in one line."""
        said = subprocess.run(["xdotool", "getwindowname", self.handle], env=self.environment, check=True,
                              capture_output=True, text=True).stdout
        return " ".join(said.split())

    def save_as(self, what):
        """Under the name that is offered."""
        self.click(f"Save/{what}...")
        self.wait_for(lambda: "File/name" in self.state()["controls"], "no file can be chosen")
        self.use(2, "key", "Return")

    def point(self, place):
        self.xdotool("mousemove", "--window", self.handle, round(place[0]), round(place[1]))

    def move(self, place):
        """Until the interface was drawn with the mouse there: what happens within one of its frames is one to it."""
        self.point(place)
        there = [round(place[0]), round(place[1])]
        self.wait_for(lambda: self.state()["mouse"] == there, f"the mouse never came to {there}")

    def place(self, control):
        x, y, width, height = self.state()["controls"][control]
        return x + width / 2, y + height / 2

    def middle(self):
        x, y, width, height = self.state()["picture"]
        return x + width / 2, y + height / 2

    def press(self, control):
        """A control by its name, or a place."""
        place = self.place(control) if isinstance(control, str) else control
        self.move(place)
        self.keep_from_double_click(place)
        self.use(1, "mousedown", 1)
        self.use(1, "mouseup", 1)

    def keep_from_double_click(self, place):
        """Waits where the last press was just here."""
        when, where = self.pressed
        if math.dist(where, place) < DOUBLE_CLICK_PIXELS:
            time.sleep(max(0, when + DOUBLE_CLICK_SECONDS - time.monotonic()))
        self.pressed = (time.monotonic(), place)

    def click(self, control):
        self.press(control)
        self.settle()

    def drag(self, begin, end, button=1, steps=5):
        self.move(begin)
        self.keep_from_double_click(begin)
        self.use(1, "mousedown", button)
        for step in range(1, steps + 1):
            self.move([a + (b - a) * step / steps for a, b in zip(begin, end)])
        self.use(1, "mouseup", button)
        self.settle()

    def key(self, name):
        self.use(2, "key", name)
        self.settle()

    def choose(self, control, entry):
        self.click(control)
        self.wait_for(lambda: f"{control}/{entry}" in self.state()["controls"], f"{control} has no {entry}")
        self.click(f"{control}/{entry}")

    def only(self, section):
        """That section open and no other."""
        for name in ("Medium", "Material", "Light", "Method", "Motion", "Truth", "View", "Time", "Save"):
            controls = self.state()["controls"]
            is_open = any(known.startswith(name + "/") for known in controls)
            if is_open != (name == section):
                self.click(name)

    def picture(self):
        """What the screen shows in the picture's area once it shows the same twice: a display takes its time."""
        before, shown = None, self.shown()
        while before is None or before.data != shown.data:
            time.sleep(.1)
            before, shown = shown, self.shown()
        return shown

    def shown(self):
        """What the screen shows there right now."""
        x, y, width, height = self.state()["picture"]
        data = subprocess.run(["import", "-window", "root", "-crop", f"{width}x{height}+{x}+{y}", "-depth", "8", "rgb:-"],
                              env=self.environment, check=True, capture_output=True).stdout
        return Shot(width, height, data)

    def close(self):
        """By its own key."""
        self.xdotool("key", "ctrl+q")
        self.await_end()

    def await_end(self):
        """A message of the validation layer is a failure."""
        self.test.assertEqual(self.process.wait(LONGEST_SECONDS), 0, self.said())
        self.test.assertNotIn("alidation", self.said())


class WindowTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.config = self.folder / "config"
        self.config.mkdir()
        self.display = start_display(self)

    def view(self, *arguments, **keywords):
        return Window(self, self.display, *arguments, **keywords).open()

    def rendered(self, window, *arguments):
        """What `render` draws of a scene, as large as the window's picture."""
        _, _, width, height = window.state()["picture"]
        self.succeed("render", *arguments, "--size", f"{width}x{height}", "--quiet", "-o", "rendered.png")
        return Shot.of(read_png((self.folder / "rendered.png").read_bytes()))

    def resident_megabytes(self, window):
        for line in pathlib.Path(f"/proc/{window.process.pid}/status").read_text(encoding="utf-8").splitlines():
            if line.startswith("VmRSS:"):
                return int(line.split()[1]) / 1024
        raise AssertionError("no VmRSS")

    def cpu_seconds(self, window):
        fields = pathlib.Path(f"/proc/{window.process.pid}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
