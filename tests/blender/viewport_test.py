"""The viewport's rendered mode in a window of Blender, on a display of its own."""

import os
import shutil
import subprocess
import unittest

from blender_test import BLENDER, HERE, BlenderTest


@unittest.skipIf(BLENDER is None, "Blender is not installed")
@unittest.skipIf(shutil.which("Xvfb") is None, "Xvfb is not installed")
class Viewport(BlenderTest):
    def start_display(self):
        read, write = os.pipe()
        server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "640x480x24", "-nolisten", "tcp"],
                                  pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        self.addCleanup(server.wait)
        self.addCleanup(server.kill)
        with os.fdopen(read) as pipe:
            return ":" + pipe.readline().strip()

    def run_in_window(self, script):
        words = [BLENDER, "--factory-startup", "--window-geometry", "0", "0", "640", "480",  # the least that Blender takes
                 "--python", HERE / "inside" / f"{script}.py", "--", self.folder]
        text = self.run_blender(words, DISPLAY=self.start_display())
        self.assertIn("DONE", text)

    @unittest.skipIf(shutil.which("import") is None, "ImageMagick's import is not installed")
    def test_it_follows_what_an_artist_does(self):
        self.run_in_window("viewport")

    @unittest.skipIf(shutil.which("xdotool") is None, "xdotool is not installed")
    def test_escape_cancels_a_render(self):
        self.run_in_window("escape")


if __name__ == "__main__":
    unittest.main()
