"""One frame of every method under core and synchronization validation, which --validation makes an error."""

import os
import unittest

from program import ProgramTest

BOUNDARY = ("--transport", "boundary", "--max-surfels", 4096, "--max-clusters", 256)
DIPOLE = ("--transport", "dipole")
METHODS = (
    BOUNDARY,
    (*BOUNDARY, "--ambient", "0.3,0.3,0.3", "--ground", "--bounces", 1, "--site", "vertex"),
    (*BOUNDARY, "--aov", "irradiance"),
    (*DIPOLE, "--max-surfels", 4096, "--deform", "wobble:0.05:1", "--time", 0.3, "--site", "vertex"),
    ("--transport", "better-dipole", "--sum", "all", "--max-surfels", 2048),
    (*DIPOLE, "--sum", "pattern", "--dsm-size", 64),
    (*DIPOLE, "--sum", "pattern", "--dsm-size", 64, "--aov", "dsm-irradiance"),
)


class Validation(ProgramTest):
    def test_every_method(self):
        env = {**os.environ, "VK_LAYER_ENABLES": "VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT"}
        for method in METHODS:
            with self.subTest(method=method):
                run = self.succeed("render", "--builtin", "bear", "--medium", "marble", "--size", "32x32", "--shadow-size", 64,
                                   "--antialias", 1, *method, "--validation", "-o", "a.exr", env=env)
                self.assertNotIn("alidation", run.err)


if __name__ == "__main__":
    unittest.main()
