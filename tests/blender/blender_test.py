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

    def compare(self, a, b):
        done = subprocess.run([PROGRAM, "compare", a, b, "--block", "8", "--json"], capture_output=True, text=True, check=True)
        return json.loads(done.stdout)

    def test_an_animation_is_whole_and_its_gltf_looks_the_same(self):
        self.run_inside("animation")
        facts = json.loads(subprocess.run([PROGRAM, "info", "frame2.glb", "--json"], cwd=self.folder, capture_output=True,
                                          check=True).stdout)
        centre = [(low + high) / 2 for low, high in zip(facts["bounds_min_mm"], facts["bounds_max_mm"])]
        # 0.4 W over four times 0.05 m by 0.05 m, 100 mm above the origin, shining down.
        lamp = ",".join(str(at - middle) for at, middle in zip((0, 100, 0), centre)) + ":25,0,0:0,0,25:40"
        subprocess.run([PROGRAM, "render", "frame2.glb", "--medium", "marble", "--rectangle", lamp, "--size", "96x96", "--antialias",
                        "1", "--roughness", "0.5", "--quiet", "-o", "gltf.exr"], cwd=self.folder, check=True)
        found = self.compare(self.folder / "frame0002.exr", self.folder / "gltf.exr")
        self.assertLess(found["block"]["rel_rmse"], 0.03, found)

    def test_lamps_and_the_world_are_as_bright_as_in_cycles(self):
        self.run_inside("lamps")

    def test_pictures_on_inputs_look_as_in_cycles(self):
        self.run_inside("textures")

    def test_names_of_newer_blenders_mean_what_they_say(self):
        self.run_inside("newer_names")

    def test_awkward_scenes(self):
        self.run_inside("awkward")

    def test_without_a_device_there_is_a_sentence(self):
        text = self.run_inside("no_device", VK_ICD_FILENAMES="/none", VK_DRIVER_FILES="/none")
        self.assertIn("SAID: Error: Opaline: no Vulkan device was found", text)


if __name__ == "__main__":
    unittest.main()
