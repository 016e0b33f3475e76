"""Figures and table of the accuracy page, from runs whose outcome is known."""

import contextlib
import io
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))

import accuracy

# 100 blocks of 64 pixels, 25 of which the body fills.
COMPARED = {"rel_rmse": .4, "rel_bias": -.3, "covered_pixels": 1600,
            "block": {"blocks": 100, "covered_blocks": 25, "covered_rel_rmse": .05}}


class Known(accuracy.Bench):
    """Images are their names, and all differ alike."""

    def __init__(self):
        self.asked = []

    models = pathlib.Path("models")

    def image(self, name, *arguments):
        self.asked.append((name, arguments))
        return name, {"block_error": .03}

    def compare(self, a, b, *options):
        return COMPARED


class Figures(unittest.TestCase):
    def test_errors_of_a_truth_are_taken_as_distances_are(self):
        self.assertAlmostEqual(accuracy.truth_error(.03, COMPARED), .03)
        # Where blocks are half empty, the mean over what is covered is twice the mean block.
        self.assertAlmostEqual(accuracy.truth_error(.03, {**COMPARED, "covered_pixels": 800}), .015)

    def test_noise_is_taken_off_as_squares(self):
        self.assertAlmostEqual(accuracy.without_noise(.05, .03), .04)
        self.assertEqual(accuracy.without_noise(.02, .03), 0)

    def test_a_closed_scene(self):
        bench = Known()
        row = accuracy.measure(bench, accuracy.Case("Ball", "ball.ply", "jade"))
        self.assertEqual(row["pattern"], .4)
        self.assertEqual(row["on_body"], .25)
        for transport in accuracy.TRANSPORTS:
            self.assertAlmostEqual(row[transport, None], .04)
        self.assertEqual([name for name, _ in bench.asked], ["ball-jade-pattern", "ball-jade-dipole",
                         "ball-jade-better-dipole", "ball-jade-path-0", "ball-jade-path-default"])
        for name, arguments in bench.asked:
            self.assertIn("models/ball.ply", arguments)
            self.assertEqual("--bounces" in arguments, name.endswith("path-0"))

    def test_an_open_scene_is_not_path_traced(self):
        bench = Known()
        case = accuracy.Case("Teapot", "teapot", "jade", closed=False)
        row = accuracy.measure(bench, case)
        self.assertFalse([name for name, _ in bench.asked if "path" in name])
        self.assertIn("| Teapot | jade | 40 % | – | – | – | – | 25 % |", accuracy.table([(case, row)]))

    def test_table(self):
        case = accuracy.Case("Max Planck", "a.ply", "jade")
        self.assertEqual(case.name, "max-planck-jade")
        text = accuracy.table([(case, accuracy.measure(Known(), case))]).splitlines()
        self.assertEqual(text[2], "| Max Planck | jade | 40 % | 4.0 / 4.0 % | 4.0 / 4.0 % | 30 / 30 % | 3.0 / 3.0 % "
                         "| 25 % |")
        self.assertEqual({line.count("|") for line in text}, {9})


class Work(unittest.TestCase):
    def test_what_is_there_is_not_made_again(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            program = folder / "program"
            program.write_text('#!/bin/sh\necho run >> "$0.log"\nfor f; do last=$f; done\n: > "$last"\n'
                               'while [ "$1" != --report ]; do shift; done\necho "{}" > "$2"\n')
            program.chmod(0o755)
            bench = accuracy.Bench(str(program), folder, folder / "work")
            log = folder / "program.log"
            for arguments, runs in ((("render", "x"), 1), (("render", "x"), 1), (("render", "y"), 2)):
                with contextlib.redirect_stderr(io.StringIO()):
                    self.assertEqual(bench.image("a", *arguments), (folder / "work" / "a.exr", {}))
                self.assertEqual(len(log.read_text().splitlines()), runs)


if __name__ == "__main__":
    unittest.main()
