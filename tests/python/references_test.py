"""References agree with each other, let other threads run, and end when Ctrl C is pressed."""

import os
import signal
import subprocess
import sys
import threading
import unittest

import numpy as np
from bodies import scene, small

import opaline

ENDLESS = """
import sys
sys.path.insert(0, sys.argv[1])
from bodies import scene
import opaline
print("begins", flush=True)
try:
    opaline.path(scene(), 64, 64, aov="exitance", error=1e-9)
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


class References(unittest.TestCase):
    def test_the_tree_is_near_the_integral(self):
        made = scene()
        truth = opaline.integral(made, 24, 16, "exitance")
        self.assertEqual(truth["exitance"].shape, (16, 24, 4))
        self.assertLess(truth.facts["relative_error"], 1e-2)
        ours = opaline.Renderer(made).render(24, 16, "exitance", transport="dipole")
        self.assertLess(opaline.compare(ours["exitance"], truth["exitance"])["rel_rmse"], .02)

    def test_a_seed_is_a_picture(self):
        made = scene()
        once, again, other = (opaline.path(made, 16, 12, "exitance", particles=20000, seed=seed)["exitance"] for seed in (1, 1, 2))
        np.testing.assert_array_equal(once, again)
        self.assertFalse(np.array_equal(once, other))

    def test_radiance_has_what_surfaces_mirror_unless_told_otherwise(self):
        made = scene()
        with_reflection, without = (opaline.path(made, 16, 12, particles=2000, specular=specular)["radiance"][..., :3].sum()
                                    for specular in (True, False))
        self.assertGreater(with_reflection, 1.01 * without)

    def test_what_is_refused(self):
        made = scene()
        for wrong in ({"aov": "surfels"}, {"width": 0}, {"aov": "radiance", "antialias": 5}, {"error": 0}, {"particles": 0},
                      {"roughness": 2}):
            with self.subTest(wrong), self.assertRaises(opaline.UsageError):
                opaline.path(made, **{"width": 8, "height": 8, **wrong})
        for wrong in ({"transport": "boundary"}, {"tolerance": 2}, {"aov": "dsm-area"}):
            with self.subTest(wrong), self.assertRaises(opaline.UsageError):
                opaline.integral(made, **{"width": 8, "height": 8, "aov": "exitance", **wrong})

    def test_other_threads_run(self):
        counted, done = [0], threading.Event()

        def count():
            while not done.is_set():
                counted[0] += 1

        thread = threading.Thread(target=count)
        thread.start()
        try:
            made, renderer = scene(), opaline.Renderer(scene())
            for work in (lambda: opaline.path(made, 32, 32, "exitance", particles=30000),
                         lambda: small(renderer, "exitance", transport="boundary")):
                before = counted[0]
                work()
                self.assertGreater(counted[0] - before, 1000)
        finally:
            done.set()
            thread.join()

    def test_control_c(self):
        child = subprocess.Popen([sys.executable, "-c", ENDLESS, os.path.dirname(os.path.abspath(__file__))], text=True,
                                 stdout=subprocess.PIPE)
        with child:
            self.assertEqual(child.stdout.readline(), "begins\n")
            threading.Timer(1, child.send_signal, (signal.SIGINT,)).start()
            self.assertEqual(child.stdout.read(), "interrupted\n")
            self.assertEqual(child.wait(60), 0)


if __name__ == "__main__":
    unittest.main()
