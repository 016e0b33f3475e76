"""tools/regions.py on pictures of four blocks."""

import contextlib
import io
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tests" / "cli")]

import images
import regions

EDGE = 8


def picture(blocks):
    """A row of blocks, each of one colour; None is background."""
    row = [(*colour, 1.0) if colour else (0.0, 0.0, 0.0, 0.0) for colour in blocks for _ in range(EDGE)]
    return images.Picture([row] * EDGE)


class Regions(unittest.TestCase):
    def table(self, ours, truth, irradiance, facing):
        with tempfile.TemporaryDirectory() as folder:
            pictures = {}
            name = {key: str(pathlib.Path(folder) / key) for key in ("ours", "irradiance", "normal", "truth")}
            for key, blocks in (("ours", ours), ("irradiance", irradiance),
                                ("normal", [(0.0, 0.0, z) for z in facing])):
                grey = [block if isinstance(block, tuple) else (block,) * 3 for block in blocks]
                pathlib.Path(name[key]).write_text(key, encoding="utf-8")
                pictures[key.encode()] = picture(grey)
            rows = [f"{x},0,64," + ",".join([f"{value}"] * 6) for x, value in enumerate(truth)]
            header = "block_x,block_y,covered,first_r,first_g,first_b,second_r,second_g,second_b"
            pathlib.Path(name["truth"]).write_text("\n".join([header, *rows]) + "\n", encoding="utf-8")
            out = io.StringIO()
            arguments = ["regions.py", name["ours"], name["truth"], name["irradiance"], name["normal"]]
            with mock.patch.object(sys, "argv", arguments), contextlib.redirect_stdout(out), \
                    mock.patch.object(images, "read_exr", pictures.get):
                regions.main()
        return {line.split()[0]: line.split()[1:] for line in out.getvalue().splitlines()[1:]}

    def test_each_block_counts_where_it_belongs(self):
        table = self.table(ours=[1.5, 1.0, 2.0, 0.5], truth=[1.0, 1.0, 1.75, 0.25],
                           irradiance=[3.0, 0.0, 0.0, 0.0], facing=[1.0, 0.2, 1.0, 1.0])
        self.assertEqual([table[name][0] for name in regions.REGIONS], ["1", "1", "1", "1", "4"])
        self.assertEqual([float(table[name][1]) for name in regions.REGIONS], [25, 25, 44, 6, 100])
        # Over the mean, 1, and the root of the number of blocks, 32.
        self.assertEqual([float(table[name][4]) for name in regions.REGIONS], [1.6, 0, 0.8, 0.8, 1.9])
        self.assertEqual([float(table[name][7]) for name in regions.REGIONS], [50, 0, 14.3, 100, 25])


if __name__ == "__main__":
    unittest.main()
