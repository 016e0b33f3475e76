"""Pictures of docs/ still show what their commands make: those of the built-in bear, at an eighth of their size or as they
are, and plots."""

import pathlib
import shlex
import subprocess
import sys
import unittest

from program import ProgramTest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))

import make_pictures

EDGE = 128
# Of the values that the files store, over their mean: what fewer samples, fewer unknowns and the JPEG change. A tenth of a
# stop changes the mean by 3 %.
MOST_RMSE = .08
MOST_BIAS = .01
# Another device rounds otherwise.
MOST_RMSE_OF_MAPS = .02


def of(picture):
    return next(entry for _, entry in make_pictures.entries() if picture in entry["pictures"])


class Pictures(ProgramTest):
    def test_renderings(self):
        compared = 0
        for _, entry in make_pictures.entries():
            if "small" not in entry:
                continue
            (command,), (picture,) = entry["commands"], entry["pictures"]
            self.succeed(*shlex.split(command)[1:], "--size", f"{EDGE}x{EDGE}", "--antialias", 8, *entry["small"])
            subprocess.run(["ffmpeg", "-loglevel", "error", "-i", make_pictures.IMAGES / picture, "-vf",
                            f"scale={EDGE}:{EDGE}:flags=area", "shown.png"], cwd=self.folder, check=True)
            figures = self.succeed("compare", "shown.png", entry["pictures"][picture], "--json").json()
            for where in (figures, *figures["channels"].values()):
                self.assertLess(where["rel_rmse"], MOST_RMSE, picture)
                self.assertLess(abs(where["rel_bias"]), MOST_BIAS, picture)
            compared += 1
        self.assertGreater(compared, 0)

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
