"""The engine of examples/vulkan draws without a word of the validation layer, and a lost device ends it with one sentence,
after which nothing is left. In a build with sanitizers these say so too."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

DEVICE_LOST = -4
FRAMES = 3


class Engine(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def draw(self, *words, **environment):
        return subprocess.run([os.environ["ENGINE"], str(FRAMES), self.folder / "engine.png", *words], capture_output=True,
                              text=True, check=False, env=os.environ | environment)

    def draw_with_fault(self, function, nth):
        """What it did, and the report: the function that failed or "none", how often it was called, what is left."""
        report = self.folder / "report.txt"
        report.unlink(missing_ok=True)
        done = self.draw(VK_ADD_LAYER_PATH=str(pathlib.Path(os.environ["OPALINE_FAULT_LAYER"]).parent),
                         VK_INSTANCE_LAYERS="VK_LAYER_OPALINE_faults", OPALINE_FAULT=f"{DEVICE_LOST}:{nth}:{function}",
                         OPALINE_FAULT_REPORT=str(report))
        failed, calls, left = re.fullmatch(r"(\w+) (\d+) calls, left: (.*)\n", report.read_text()).groups()
        return done, failed, int(calls), left

    def test_the_validation_layer_is_silent(self):
        done = self.draw("--validate")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_a_lost_device_ends_it_and_nothing_is_left(self):
        for function in ("vkQueueSubmit2", "vkWaitSemaphores"):
            done, failed, calls, left = self.draw_with_fault(function, 0)
            self.assertEqual((done.returncode, done.stderr, failed, left), (0, "", "none", "nothing"))
            self.assertGreater(calls, FRAMES)
            for nth in (1, calls // 2):  # how often it waits in all is a matter of time
                with self.subTest(function=function, nth=nth):
                    done, failed, _, left = self.draw_with_fault(function, nth)
                    self.assertEqual((done.returncode, failed, left), (1, function, "nothing"), done.stderr)
                    self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)


if __name__ == "__main__":
    unittest.main()
