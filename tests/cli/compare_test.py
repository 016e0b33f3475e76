"""`compare` against figures worked out by hand."""

import math
import unittest

from images import read_png, write_exr, write_png
from program import ProgramTest

CHANNELS = "rgb"


def grey(*values):
    return [(value, value, value, 1) for value in values]


class Figures(ProgramTest):
    def compare(self, a, b, *options):
        self.write("a.exr", write_exr(a))
        self.write("b.exr", write_exr(b))
        return self.succeed("compare", "a.exr", "b.exr", "--json", *options).json()

    def test_equal_images(self):
        report = self.compare([grey(1, 2)], [grey(1, 2)])
        for name in ("rel_rmse", "rel_bias", "p95_rel", "max_abs", "flip"):
            self.assertEqual(report[name], 0, name)
        self.assertIsNone(report["psnr_db"])
        self.assertEqual((report["covered_pixels"], report["size"], report["values"]), (2, [2, 1], "linear"))
        self.assertEqual(report["regions"], {})

    def test_known_differences(self):
        b = [[(1, 2, 4, 1), (3, 6, 12, 1), (9, 9, 9, 0)]]
        a = [[(2, 2, 4, 1), (3, 6, 12, 1), (1, 1, 1, 1)]]
        report = self.compare(a, b)
        self.assertEqual(report["covered_pixels"], 2)
        self.assertAlmostEqual(report["rel_rmse"], math.sqrt(1 / 6) / (28 / 6))
        self.assertAlmostEqual(report["rel_bias"], 1 / 28)
        self.assertAlmostEqual(report["psnr_db"], 10 * math.log10(144 * 6))
        self.assertAlmostEqual(report["p95_rel"], .75 / (28 / 6))  # rank 4.75 of 0 … 5
        self.assertEqual(report["max_abs"], 1)
        self.assertAlmostEqual(report["channels"]["r"]["rel_rmse"], math.sqrt(1 / 2) / 2)
        self.assertEqual(report["channels"]["g"]["rel_rmse"], 0)
        self.assertEqual(set(report["channels"]), set(CHANNELS))
        self.assertAlmostEqual(self.compare(a, b, "--peak", "1")["psnr_db"], 10 * math.log10(6))

    def test_negative_values_stay(self):
        self.assertEqual(self.compare([grey(-1, 1)], [grey(1, 1)])["max_abs"], 2)

    def test_mask(self):
        self.write("mask.png", write_png([[(255, 0, 0), (127, 127, 127), (128, 0, 0)]]))
        report = self.compare([grey(2, 5, 3)], [grey(1, 1, 1)], "--mask", "mask.png")
        inside, outside = report["regions"]["inside"], report["regions"]["outside"]
        self.assertEqual((inside["covered_pixels"], outside["covered_pixels"]), (2, 1))
        self.assertAlmostEqual(inside["rel_rmse"], math.sqrt((1 + 4) / 2))
        self.assertAlmostEqual(outside["rel_rmse"], 4)
        self.write("none.png", write_png([[(0, 0, 0)] * 3]))
        report = self.compare([grey(2, 5, 3)], [grey(1, 1, 1)], "--mask", "none.png")
        self.assertIsNone(report["regions"]["inside"])
        self.assertEqual(report["regions"]["outside"]["covered_pixels"], 3)

    def test_blocks(self):
        report = self.compare([grey(2, 0, 2, 1)] * 2, [grey(1, 1, 1, 1)] * 2, "--block", "2")
        # The first block's errors cancel; the second's are 1 in half of the block.
        self.assertAlmostEqual(report["block"]["rel_rmse"], math.sqrt(.25 / 2))
        self.assertEqual((report["block"]["blocks"], report["block"]["covered_blocks"]), (2, 2))

    def test_a_black_reference_has_no_relative_error(self):
        report = self.compare([grey(1)], [grey(0)])
        self.assertIsNone(report["rel_rmse"])
        self.refused_after_figures("--fail-above", "1000")

    def refused_after_figures(self, *options):
        run = self.run_program("compare", "a.exr", "b.exr", *options)
        self.assertEqual(run.status, 1)
        self.assertIn("rel_rmse", run.out)
        self.assertRegex(run.err, "^opaline: --fail-above .*rel_rmse.*\n$")

    def test_fail_above(self):
        self.compare([grey(1.25)], [grey(1)])  # rel_rmse is 0.25
        self.succeed("compare", "a.exr", "b.exr", "--fail-above", ".25")
        self.refused_after_figures("--fail-above", ".2499")
        self.refused_after_figures("--fail-above", "0", "--json")

    def test_table(self):
        self.compare([grey(1.25)], [grey(1)])
        out = self.succeed("compare", "a.exr", "b.exr", "--block", "8").out
        self.assertRegex(out, r"(?m)^rel_rmse +0\.25 +0\.25 +0\.25 +0\.25$")
        self.assertRegex(out, r"(?m)^flip +0\.\d+$")
        self.assertLessEqual(max(map(len, out.splitlines())), 100)


class Pictures(ProgramTest):
    def test_png_values_are_those_stored(self):
        self.write("a.png", write_png([[(255, 0, 0), (51, 51, 51)]]))
        self.write("b.png", write_png([[(204, 0, 0), (51, 51, 51)]]))
        report = self.succeed("compare", "a.png", "b.png", "--json").json()
        self.assertEqual((report["values"], report["covered_pixels"]), ("picture", 2))
        self.assertAlmostEqual(report["max_abs"], .2, places=6)
        self.assertAlmostEqual(report["psnr_db"], 10 * math.log10(6 / .04), places=5)  # peak 1

    def test_flip_of_black_and_white(self):
        self.write("a.png", write_png([[(0, 0, 0)]]))
        self.write("b.png", write_png([[(255, 255, 255)]]))
        # By hand in the tests of FLIP itself.
        self.assertAlmostEqual(self.succeed("compare", "a.png", "b.png", "--json").json()["flip"], .96738, places=4)

    def test_a_linear_image_beside_a_png_becomes_what_render_makes_of_it(self):
        # sRGB 188 is linear 0.5029 (IEC 61966-2-1); one stop more is twice as much.
        self.write("a.exr", write_exr([[(.50289, .50289, .50289, 1), (5, 5, 5, 0)]]))
        self.write("b.png", write_png([[(188, 188, 188, 255), (0, 0, 0, 255)]]))
        report = self.succeed("compare", "a.exr", "b.png", "--json", "--tone", "none").json()
        self.assertEqual((report["max_abs"], report["covered_pixels"], report["values"]), (0, 1, "picture"))
        report = self.succeed("compare", "a.exr", "b.png", "--json", "--tone", "none", "--exposure", "1").json()
        self.assertAlmostEqual(report["max_abs"], 67 / 255, places=6)

    def test_heatmap(self):
        self.write("a.exr", write_exr([grey(2, 1, 1)]))
        self.write("b.exr", write_exr([[*grey(1, 1), (1, 1, 1, 0)]]))
        run = self.succeed("compare", "a.exr", "b.exr", "--heatmap", "map.png", "--heatmap-max", "2", "--json")
        picture = read_png((self.folder / "map.png").read_bytes())
        self.assertGreater(picture.width, 3)
        self.assertEqual(picture.at(2, 0), (255, 255, 255, 255))
        lightness = [sum(picture.at(x, 0)[:3]) for x in (0, 1)]
        self.assertGreater(lightness[0], lightness[1])
        self.assertEqual(run.json()["heatmap"], {"file": "map.png", "top": 2})
        self.assertIn("map.png", run.err)
        self.assertEqual(self.succeed("compare", "a.exr", "b.exr", "--heatmap", "map.png", "--quiet").err, "")


class Refusals(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("one.exr", write_exr([grey(1)]))
        self.write("two.exr", write_exr([grey(1, 1)]))

    def test_arguments(self):
        self.refused(2, "compare", says=("needs A and B", "A is missing"))
        self.refused(2, "compare", "one.exr", says=("needs A and B", "B is missing"))
        self.refused(2, "compare", "one.exr", "one.exr", "two.exr", says=("one A and one B", "two.exr"))
        for option, text, says in [("--block", "0", "from 1"), ("--peak", "0", "above 0"), ("--fail-above", "-1", "from 0"),
                                   ("--fail-above", "nan", "must be from"), ("--pixels-per-degree", "0", "from 1 to 1000"),
                                   ("--exposure", "40", "stops"), ("--tone", "filmic", "none, neutral"),
                                   ("--heatmap", "map.jpg", ".png"), ("--heatmap-max", "0", "from"),
                                   ("--heatmap-max", "1", "--heatmap FILE.png")]:
            self.refused(2, "compare", "one.exr", "one.exr", option, text, says=(option, says))
        self.write("a.png", write_png([[(1, 2, 3)]]))
        self.refused(2, "compare", "a.png", "a.png", "--exposure", "1", says=("--exposure", "a.png"))

    def test_files(self):
        self.refused(1, "compare", "one.exr", "none.exr", says="none.exr")
        self.refused(1, "compare", "none.png", "one.exr", says="none.png")
        self.write("text.exr", "no image")
        self.refused(1, "compare", "one.exr", "text.exr", says=("text.exr", "neither"))
        self.write("cut.png", write_png([[(1, 2, 3)] * 50])[:60])
        self.refused(1, "compare", "cut.png", "one.exr", says=("cut.png", "PNG"))
        self.write("cut.exr", write_exr([grey(*range(1, 50))] * 50)[:600])
        self.assertNotIn("..", self.refused(1, "compare", "cut.exr", "one.exr", says=("cut.exr", "OpenEXR")).err)
        self.refused(1, "compare", "one.exr", "one.exr", "--mask", "none.exr", says="none.exr")
        # Before the inputs are read.
        self.refused(1, "compare", "none.exr", "one.exr", "--heatmap", "missing/map.png", says="missing")

    def test_sizes(self):
        self.refused(1, "compare", "one.exr", "two.exr", says=("one.exr has 1x1", "two.exr 2x1", "one size"))
        self.refused(1, "compare", "one.exr", "one.exr", "--mask", "two.exr", says=("two.exr has 2x1", "one.exr"))

    def test_no_common_pixel(self):
        self.write("left.exr", write_exr([[(1, 1, 1, 1), (1, 1, 1, 0)]]))
        self.write("right.exr", write_exr([[(1, 1, 1, 0), (1, 1, 1, 1)]]))
        self.refused(1, "compare", "left.exr", "right.exr", says=("left.exr and right.exr", "no pixel that both cover"))

    def test_what_is_not_a_number(self):
        for value in (math.nan, math.inf):
            self.write("bad.exr", write_exr([grey(value)]))
            for pair in (("bad.exr", "one.exr"), ("one.exr", "bad.exr")):
                self.refused(1, "compare", *pair, says=("bad.exr", "infinite or not a number"))


if __name__ == "__main__":
    unittest.main()
