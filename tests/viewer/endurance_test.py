"""Hundreds of inputs that nobody would make on purpose; as many as fit into OPALINE_MINUTES, where that is set."""

import os
import random
import time
import unittest

from driver import CORNERS, WindowTest
from program import CUBE_OBJ

KEYS = ("f", "t", "space", "Left", "Right", "c", "h", "Tab", "o", "x", "question", "Escape", "Return", "Up", "Down", "1", "Delete")


# `make endurance` asks for an hour of them.
MINUTES = float(os.environ.get("OPALINE_MINUTES", "0"))
SEED = int(os.environ.get("OPALINE_SEED", "7"))
FEWEST = 500


class Endurance(WindowTest):
    def test_random_inputs(self):
        self.write("cube.obj", CUBE_OBJ)
        window = self.view("cube.obj", *CORNERS, "--size", "640x480")
        choice = random.Random(SEED)
        begin = time.monotonic()
        reports, inputs = 0, 0
        while inputs < FEWEST or time.monotonic() < begin + 60 * MINUTES:
            self.act(window, choice)
            inputs += 1
            self.assertIsNone(window.process.poll(), f"input {inputs} of seed {SEED}: {window.said()}")
            minutes = (time.monotonic() - begin) / 60
            if MINUTES and minutes >= reports:
                print(f"{minutes:.0f} minutes, {inputs} inputs, {window.state()['frames']} frames, "
                      f"{self.resident_megabytes(window):.0f} MB", flush=True)
                reports += 1
        window.use(2, "key", "Escape")
        # Nothing is lost with what is done again and again.
        memory = []
        for _ in range(3):
            for size in ((400, 300), (700, 500), (640, 480)):
                window.xdotool("windowsize", window.handle, *size)
                window.drag((20, 100), (150, 120))
            memory.append(self.resident_megabytes(window))
        self.assertLess(memory[-1], 1.1 * memory[0], memory)
        # Whatever was begun by chance is given up.
        window.xdotool("key", "ctrl+q", "Return")
        window.await_end()

    @staticmethod
    def act(window, choice):
        x, y = choice.randrange(640), choice.randrange(480)
        kind = choice.random()
        if kind < .35:
            window.point((x, y))
            window.xdotool("click", choice.choice((1, 1, 1, 3, 4, 5)))
        elif kind < .65:
            window.point((x, y))
            window.xdotool("mousedown", 1)
            window.point((choice.randrange(640), choice.randrange(480)))
            window.xdotool("mouseup", 1)
        elif kind < .97:
            window.xdotool("key", choice.choice(KEYS))
        else:
            window.xdotool("windowsize", window.handle, choice.randrange(320, 800), choice.randrange(240, 600))


if __name__ == "__main__":
    unittest.main()
