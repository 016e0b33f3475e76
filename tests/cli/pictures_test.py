"""Pictures of docs/ still match their commands. Those of the built-in bear are made at an eighth of their size or at
full size, as are plots; of those of models, a quarter is tested."""

import os
import pathlib
import shlex
import subprocess
import sys
import unittest

from program import ProgramTest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))

import make_pictures
from repository import models_folder

EDGE = 128
# Of the values that the files store, over their mean: what fewer samples, fewer unknowns and the JPEG change. A tenth of a
# stop changes the mean by 3 %.
MOST_RMSE = .08
MOST_BIAS = .01
# Devices round differently.
MOST_RMSE_OF_MAPS = .02


def of(picture):
    return next(entry for _, entry in make_pictures.entries() if picture in entry["pictures"])


class Pictures(ProgramTest):
    def test_renderings(self):
        compared = 0
        for _, entry in make_pictures.entries():
            (command, *_), (picture, *_) = entry["commands"], entry["pictures"]
            if "small" not in entry or not command.startswith("opaline "):
                continue
            self.succeed(*shlex.split(command)[1:], "--size", f"{EDGE}x{EDGE}", "--antialias", 8, *entry["small"])
            self.shows(make_pictures.IMAGES / picture, entry["pictures"][picture], f"{EDGE}:{EDGE}")
            compared += 1
        self.assertGreater(compared, 0)

    def shows(self, picture, made, scale):
        """The stored picture, made smaller, equals the new one."""
        for source, target, filters in ((picture, "shown.png", f"scale={scale}:flags=area"), (made, "made.png", "null")):
            subprocess.run(["ffmpeg", "-loglevel", "error", "-y", "-i", source, "-vf", filters, target], cwd=self.folder,
                           check=True)
        figures = self.succeed("compare", "made.png", "shown.png", "--json").json()
        self.assertLess(figures["rel_rmse"], MOST_RMSE, picture)
        for channel in figures["channels"].values():
            self.assertLess(abs(channel["rel_bias"]), MOST_BIAS, picture)

    def test_figures(self):
        found = models_folder()
        if not (found / "bunny_closed.ply").is_file():
            self.skipTest("the models are not here; OPALINE_MODELS names their folder")
        for _, entry in make_pictures.entries():
            if "small" not in entry or not entry["commands"][0].startswith("opaline_figures "):
                continue
            words = [*shlex.split(entry["commands"][0])[1:], *entry["small"]]
            subprocess.run([os.environ["OPALINE_FIGURES"], *words, "--into", "."], cwd=self.folder, check=True,
                           stdout=subprocess.DEVNULL)
            for picture, made in entry["pictures"].items():
                self.shows(make_pictures.IMAGES / picture, made, "iw/4:ih/4")

    def test_heat_maps(self):
        compared = 0
        for _, entry in make_pictures.entries():
            if not entry.get("quick"):
                continue
            for command in entry["commands"]:
                self.succeed(*shlex.split(command)[1:])
            for picture, made in entry["pictures"].items():
                figures = self.succeed("compare", make_pictures.IMAGES / picture, made, "--json").json()
                self.assertLess(figures["rel_rmse"], MOST_RMSE_OF_MAPS, picture)
                compared += 1
        self.assertGreater(compared, 0)

    def test_plots(self):
        entry = of("profile_marble.svg")
        for command in entry["commands"]:
            self.succeed(*shlex.split(command)[1:])
        for picture, made in entry["pictures"].items():
            self.assertEqual((self.folder / made).read_text(), (make_pictures.IMAGES / picture).read_text(), picture)


if __name__ == "__main__":
    unittest.main()
