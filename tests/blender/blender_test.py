"""The add-on in Blender itself, as an artist gets it: from its zip, in a fresh home, without a window.

Each test is one run of Blender with a script from inside/, which ends with status 3 after a line that says what is wrong."""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
BLENDER = shutil.which("blender")
PROGRAM = os.environ["OPALINE"]
DIVISION = ("--max-surfels", "8192", "--max-clusters", "1024")  # as in inside/common.py


class BlenderTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def run_blender(self, words, **environment):
        """What it printed. No run shows a traceback."""
        home = self.folder / "home"
        home.mkdir()
        # Blender runs with the system's Python, whatever comes first on the path of whoever runs the tests.
        done = subprocess.run(words, capture_output=True, text=True, timeout=800, check=False,
                              env={**os.environ, "PATH": "/usr/bin:/bin", "HOME": str(home), "XDG_CONFIG_HOME": str(home / ".config"),
                                   **environment})
        text = done.stdout + done.stderr
        self.assertEqual(done.returncode, 0, text)
        self.assertNotIn("Traceback", text)
        return text


@unittest.skipIf(BLENDER is None, "Blender is not installed")
class Blender(BlenderTest):
    def run_inside(self, script, **environment):
        return self.run_blender([BLENDER, "-b", "--factory-startup", "--python-exit-code", "7", "--python",
                                 HERE / "inside" / f"{script}.py", "--", self.folder], **environment)

    def opaline(self, *words):
        return subprocess.run([PROGRAM, *words], cwd=self.folder, capture_output=True, check=True).stdout

    def expect_same(self, a, b):
        """Blocks of the pictures are within 3 %."""
        found = json.loads(self.opaline("compare", a, b, "--block", "8", "--json"))
        self.assertLess(found["block"]["covered_rel_rmse"], 0.03, found)

    def test_an_animation_is_whole_and_its_gltf_looks_the_same(self):
        self.run_inside("animation")
        facts = json.loads(self.opaline("info", "frame2.glb", "--json"))
        centre = [(low + high) / 2 for low, high in zip(facts["bounds_min_mm"], facts["bounds_max_mm"])]
        # A radiance of 40 over 0.05 m by 0.05 m, 100 mm above the origin, shining down.
        lamp = ",".join(str(at - middle) for at, middle in zip((0, 100, 0), centre)) + ":25,0,0:0,0,25:40"
        self.opaline("render", "frame2.glb", "--medium", "marble", "--rectangle", lamp, "--size", "96x96", "--antialias", "1",
                     "--roughness", "0.5", *DIVISION, "--quiet", "-o", "gltf.exr")
        self.expect_same("frame0002.exr", "gltf.exr")

    def test_what_the_exporter_of_gltf_writes(self):
        self.run_inside("exported")
        # Frame 9 at 24 frames a second.
        self.opaline("render", "moving.glb", "--medium", "marble", "--time", "0.375", "--directional", "0.3,1,0.5:3,3,3", "--size",
                     "96x96", "--antialias", "1", "--roughness", "0.5", *DIVISION, "--quiet", "-o", "gltf.exr")
        self.expect_same("moment.exr", "gltf.exr")
        plain, told = (json.loads(self.opaline("info", f"{name}.glb", "--json")) for name in ("plain", "told"))
        self.assertEqual([facts["materials"][0]["kind"] for facts in (plain, told)], ["opaque", "translucent"])
        lengths = told["objects"][0]["medium"]["mean_free_path_mm"]
        for channel, length in zip("rgb", (2, 1, 0.5)):
            self.assertAlmostEqual(lengths[channel], length, places=5)

    def test_lamps_and_the_world_are_as_bright_as_in_cycles(self):
        self.run_inside("lamps")

    def test_shapes_and_instances_look_as_in_cycles(self):
        self.run_inside("shapes")

    def test_cameras_view_layers_and_units_decide_what_cycles_shows(self):
        self.run_inside("views")

    def test_pictures_on_inputs_look_as_in_cycles(self):
        self.run_inside("textures")

    def test_sheets_let_light_through_as_in_cycles(self):
        self.run_inside("sheets")

    def test_light_spreads_as_far_as_in_cycles(self):
        self.run_inside("spread")

    def test_names_of_newer_blenders_mean_what_they_say(self):
        self.run_inside("newer_names")

    def test_awkward_scenes(self):
        text = self.run_inside("awkward")
        self.assertIn("the camera's clip distances cut nothing off: Camera", text)

    def test_without_a_device_there_is_a_sentence(self):
        text = self.run_inside("no_device", VK_ICD_FILENAMES="/none", VK_DRIVER_FILES="/none")
        self.assertIn("SAID: Error: Opaline: no Vulkan device was found", text)


if __name__ == "__main__":
    unittest.main()
