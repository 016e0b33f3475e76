"""Hundreds of inputs that nobody would make on purpose."""

import random
import unittest

from driver import CORNERS, WindowTest
from program import CUBE_OBJ

KEYS = ("f", "t", "space", "Left", "Right", "c", "h", "Tab", "o", "x", "question", "Escape", "Return", "Up", "Down", "1", "Delete")


class Endurance(WindowTest):
    def test_five_hundred_inputs(self):
        self.write("cube.obj", CUBE_OBJ)
        window = self.view("cube.obj", *CORNERS, "--size", "640x480")
        choice = random.Random(7)
        memory = []
        for step in range(500):
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
            self.assertIsNone(window.process.poll(), f"input {step}: {window.said()}")
            if step % 100 == 99:
                memory.append(self.resident_megabytes(window))
        # What it knows of every method and size is there after the first hundreds.
        self.assertLess(memory[-1], 1.25 * max(memory[1], memory[2]) + 50, memory)
        window.xdotool("key", "Escape")
        window.close()


if __name__ == "__main__":
    unittest.main()
