"""What becomes of the window when its display or its device fails: it goes on, or ends with one sentence."""

import os
import pathlib
import random
import time
import unittest

from driver import CORNERS, Window, WindowTest, start_server
from program import CUBE_OBJ

LAYER = pathlib.Path(os.environ["OPALINE_FAULT_LAYER"]).parent

DEVICE_LOST, NO_HOST_MEMORY, SURFACE_LOST, OUT_OF_DATE, TIMEOUT = -4, -1, -1000000000, -1000001004, 2

SCENE = ("cube.obj", *CORNERS, "--size", "400x300")


class FaultsTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.write("cube.obj", CUBE_OBJ)

    def assert_ended_with_a_sentence(self, window):
        self.assertEqual(window.process.wait(60), 1, window.said())
        said = [line for line in window.said().splitlines() if not line.startswith("note: ")]
        self.assertEqual(len(said), 1, said)


class Display(FaultsTest):
    def test_it_goes_away(self):
        choice = random.Random(3)
        for motion in ((), ("--deform", "twist:0.5:1")):
            with self.subTest(motion=motion):
                display, server = start_server(self, "640x480")
                window = Window(self, display, *SCENE, *motion)
                window.wait_for(lambda: window.places.exists() and window.state()["frames"] > 0, "no picture came")
                time.sleep(choice.uniform(0, .5))
                server.kill()
                self.assert_ended_with_a_sentence(window)


class Presenting(FaultsTest):
    def with_fault(self, result, nth, function):
        self.report = self.folder / "report.txt"
        self.report.unlink(missing_ok=True)
        return Window(self, self.display, *SCENE, environment={
            "VK_ADD_LAYER_PATH": str(LAYER), "VK_INSTANCE_LAYERS": "VK_LAYER_OPALINE_faults",
            "OPALINE_FAULT": f"{result}:{nth}:{function}", "OPALINE_FAULT_REPORT": str(self.report)})

    def test_what_passes(self):
        """The surface is made anew, and the picture is that of a window which met no failure."""
        expected = None
        for result, function in ((None, None), (OUT_OF_DATE, "vkAcquireNextImageKHR"), (OUT_OF_DATE, "vkQueuePresentKHR"),
                                 (SURFACE_LOST, "vkAcquireNextImageKHR"), (SURFACE_LOST, "vkQueuePresentKHR"),
                                 (TIMEOUT, "vkAcquireNextImageKHR"), (TIMEOUT, "vkWaitForFences")):
            with self.subTest(result=result, function=function):
                window = self.with_fault(result or TIMEOUT, 2 if result else 0, function or "none").open()
                window.settle()
                shown = window.picture()
                expected = expected or shown
                self.assertEqual(shown.worst(expected), 0)
                window.close()
                self.assertTrue(self.report.read_text(encoding="utf-8").startswith(function or "none"))

    def test_what_does_not(self):
        for result, nth, function in ((DEVICE_LOST, 2, "vkQueuePresentKHR"), (DEVICE_LOST, 1, "vkAcquireNextImageKHR"),
                                      (NO_HOST_MEMORY, 1, "vkCreateSwapchainKHR"), (SURFACE_LOST, 1, "vkCreateSwapchainKHR"),
                                      (NO_HOST_MEMORY, 3, "vkWaitForFences"), (NO_HOST_MEMORY, 2, "vkCreateSemaphore"),
                                      (NO_HOST_MEMORY, 1, "vkCreateRenderPass")):
            with self.subTest(result=result, nth=nth, function=function):
                self.assert_ended_with_a_sentence(self.with_fault(result, nth, function))


if __name__ == "__main__":
    unittest.main()
