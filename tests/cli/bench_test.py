"""`bench`: what its suites accept and report."""

import json
import math
import os
import unittest

from json_keys import documented, keys, without_medium
from program import ProgramTest

# Gong et al. 2008, Table 1.
PAPER = [("Teapot", 53.74, 91.80), ("Buddha", 29.95, 23.01), ("Max Planck", 35.62, 28.93), ("Bunny", 27.73, 20.48),
         ("Bunny/Egg", 29.19, 24.12)]
FILES = ("teapot.ply", "buddha.ply", "max_planck.ply", "bunny.ply", "bunny_egg_a.ply", "bunny_egg_b.ply")


def tetrahedron(height):
    return ("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
            f"0 0 0\n1 0 0\n0 {height} 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")


class Table1(ProgramTest):
    def without_models(self):
        return {name: value for name, value in os.environ.items() if name != "OPALINE_MODELS"}

    def test_says_where_it_looked_for_models(self):
        self.refused(1, "bench", "table1", env=self.without_models(),
                     says=("teapot.ply", "../shared/models", "OPALINE_MODELS"))
        self.refused(1, "bench", "table1", env={**os.environ, "OPALINE_MODELS": "elsewhere"}, says="elsewhere")
        self.refused(1, "bench", "table1", "--models", "here", says=("here", "--models"))

    def test_rows(self):
        # Minimal stand-ins, seen edge on: the table has the same form.
        models = self.folder / "models"
        models.mkdir()
        for name in FILES:
            (models / name).write_text(tetrahedron(.04 if name == "bunny_egg_b.ply" else .02))
        run = self.succeed("bench", "table1", "--frames", 1, "--models", "models", "--json")
        table = run.json()
        self.assertEqual(keys(table), documented("bench table1"))
        self.assertEqual([(row["data"], row["paper_ftf_fps"], row["paper_vtf_fps"]) for row in table["rows"]], PAPER)
        for row in table["rows"]:
            self.assertEqual(row["triangles"], 4)
            self.assertGreater(row["ftf_fps"], 0)
            self.assertGreater(row["vtf_fps"], 0)
            self.assertGreater(row["tree_fps"], 0)


class Methods(ProgramTest):
    # Even light, so that a few triangles with smooth normals are lit equally by all methods.
    SCENE = ("t.ply", "--diagonal-mm", 5, "--medium", "marble", "--ambient", "1,1,1")
    WAYS = (("pattern", "vertex"), ("pattern", "fragment"), ("tree", "vertex"), ("tree", "fragment"))

    def test_rows(self):
        self.write("t.ply", tetrahedron(1))
        view = ("--aov", "exitance", "--size", "24x24", "-o", "truth.exr")
        self.succeed("reference", "--path", "--samples", 4000, *self.SCENE, *view)
        run = self.succeed("bench", "methods", *self.SCENE, "--size", 24, "--frames", 1, "--truth", "truth.exr", "--all",
                           "--plot", "plot.svg", "--json")
        self.assertEqual(keys(run.json()), documented("bench methods"))
        rows = run.json()["rows"]
        self.assertEqual([(row["transport"], row["sum"], row["site"]) for row in rows],
                         [(transport, *way) for transport in ("dipole", "better-dipole")
                          for way in (*self.WAYS, ("all", "vertex"), ("all", "fragment"), ("integral", "exact"))]
                         + [("boundary", "tree", site) for site in ("vertex", "fragment")])
        for row in rows:
            self.assertGreater(row["truth_block_rel_rmse"], 0)
            if row["transport"] == "boundary":
                self.assertIsNone(row["integral_rel_rmse"])
            elif row["sum"] in ("tree", "all") and row["site"] == "fragment":
                self.assertLess(row["integral_rel_rmse"], .05)
            if row["sum"] in ("pattern", "integral"):
                self.assertIsNone(row["evaluations"])
            else:
                self.assertGreater(row["evaluations"], 0)
        self.succeed("render", *self.SCENE, "--transport", "dipole", "--sum", "all", "--size", "24x24", "-o", "all.exr", "--report", "all.json")
        # Three points per surfel.
        sources = 3 * json.loads((self.folder / "all.json").read_text())["sources"]
        for sum_of_all in (row for row in rows if row["sum"] == "all"):
            self.assertAlmostEqual(sum_of_all["evaluations"], sources, delta=1e-5 * sources)
            tree, = (row for row in rows if row["sum"] == "tree" and row["site"] == sum_of_all["site"]
                     and row["transport"] == sum_of_all["transport"])
            self.assertLess(tree["evaluations"], sum_of_all["evaluations"] / 2)
        plot = (self.folder / "plot.svg").read_text()
        for part in ("<svg", "better-dipole", "boundary", ">pattern<", ">tree<", ">all<"):
            self.assertIn(part, plot)

    def test_the_sum_of_all_is_asked_for(self):
        self.write("t.ply", tetrahedron(1))
        run = self.succeed("bench", "methods", *self.SCENE, "--size", 8, "--frames", 1, "--seconds", 0.2)
        *lines, last = run.out.splitlines()
        self.assertEqual([tuple(line.split()[:3]) for line in lines[2:]],
                         [(transport, *way) for transport in ("dipole", "better-dipole")
                          for way in (*self.WAYS, ("integral", "exact"))]
                         + [("boundary", "tree", site) for site in ("vertex", "fragment")])
        self.assertIn("evaluations", lines[1])
        # Without a picture of the truth it traces one.
        self.assertTrue(lines[1].endswith("to truth, blocks"))
        self.assertRegex(last, r"^the truth's own standard error, in blocks too: [\d.]+ %$")
        for line in lines[2:]:
            self.assertRegex(line, r" [\d.]+ %$")
            self.assertNotIn(" - ", line)

    def test_the_truths_own_error_has_the_unit_of_the_others(self):
        self.write("t.ply", tetrahedron(1))
        order = ("bench", "methods", *self.SCENE, "--size", 16, "--frames", 1)
        found = self.succeed(*order, "--seconds", 0.2, "--json").json()
        # Blocks over the rim weigh less than whole ones.
        self.assertLess(found["truth_own_rel_rmse"], found["truth_block_error"])
        self.assertGreater(found["truth_own_rel_rmse"], found["truth_block_error"] / 5)

    def test_without_any_truth_there_is_no_column_of_it(self):
        self.write("t.ply", tetrahedron(1))
        order = ("bench", "methods", *self.SCENE, "--size", 8, "--frames", 1, "--seconds", 0, "--every", 2)
        run = self.succeed(*order)
        self.assertNotIn("truth", run.out)
        self.assertNotIn(" - ", run.out)

    def test_what_is_open_has_no_row_of_boundary_transport(self):
        self.write("t.ply", tetrahedron(1).replace("face 4", "face 3").removesuffix("3 1 2 3\n"))
        run = self.succeed("bench", "methods", *self.SCENE, "--size", 8, "--frames", 1, "--json")
        self.assertIn("no comparison with the truth", run.err)
        self.assertIsNone(run.json()["truth_block_error"])
        self.assertEqual({row["transport"] for row in run.json()["rows"]}, {"dipole", "better-dipole"})

    def test_refusals(self):
        self.refused(2, "bench", "methods", "--models", "here", says="--models")
        self.refused(2, "bench", "table1", "--size", 9, says="bench methods")
        for option in (("t.ply",), ("--medium", "marble"), ("--sigma-s", "1,1,1"), ("--ambient", "1,1,1"),
                       ("--fov-degrees", 20)):
            self.refused(2, "bench", "table1", *option, says="bench methods")
        self.refused(2, "bench", "scaling", "--all", says="bench methods")
        self.refused(2, "bench", "scaling", "--seconds", 1, says="bench methods")
        self.refused(2, "bench", "methods", "--truth", "a.exr", "--seconds", 1, says=("--truth", "--seconds"))
        self.refused(2, "bench", "methods", "--every", 2, says=("--every", "--seconds 0"))
        self.refused(2, "bench", says=("table1", "methods", "scaling"))
        self.write("t.ply", tetrahedron(1))
        self.succeed("reference", "--path", "--samples", 10, "t.ply", "--size", "8x8", "--aov", "exitance", "-o", "a.exr")
        self.refused(2, "bench", "methods", "t.ply", "--truth", "a.exr", says=("--truth", "8 x 8"))
        # The truth of a different view.
        self.refused(2, "bench", "methods", "t.ply", "--size", 8, "--truth", "a.exr", "--fov-degrees", 90,
                     says=("--truth", "reference --path"))


class Scaling(ProgramTest):
    TIMES = {"gather_ms", "scatter_ms", "nearby_ms", "frame_ms", "scatter_ratio", "frame_ratio"}

    def measure(self, *options, size=32):
        self.write("t.ply", tetrahedron(1))
        # The edges of 10 mm are long compared to the mean free path of 0.4 mm.
        return self.succeed("bench", "scaling", "t.ply", "--diagonal-mm", 20, "--sigma-s", "2.5,2.5,2.5", "--sigma-a",
                            "0.02,0.01,0", "--size", size, "--frames", 1, "--max-surfels", 16384, *options)

    def assert_fits(self, rows, time, exponent):
        """What remains after fitting the logarithms has no slope."""
        logs = [(math.log(row["value"]), math.log(row[time])) for row in rows]
        middle = sum(value for value, _ in logs) / len(logs)
        self.assertAlmostEqual(sum((value - middle) * (found - exponent * value) for value, found in logs), 0)

    def test_series(self):
        run = self.measure("--plot", "plot.svg", "--json")
        found = run.json()
        self.assertEqual(without_medium(keys(found), "sigma_tr.rows[].medium"), documented("bench scaling"))
        self.assertEqual(found["size"], [32, 32])
        series = {name: found[name]["rows"] for name in ("surfels", "sigma_tr", "tolerance")}
        for rows in series.values():
            self.assertEqual((rows[0]["scatter_ratio"], rows[0]["frame_ratio"]), (1, 1))
            for row in rows:
                self.assertLessEqual(self.TIMES, set(row))
                self.assertGreater(row["scatter_ms"], 0)
                self.assertGreater(row["frame_ms"], row["scatter_ms"])
                self.assertAlmostEqual(row["scatter_ratio"], row["scatter_ms"] / rows[0]["scatter_ms"], places=9)

        # Every budget binds, and bisection uses at least half of it.
        self.assertEqual([row["max_surfels"] for row in series["surfels"]], [1024, 4096, 16384])
        for row in series["surfels"]:
            self.assertLessEqual(row["surfels"], row["max_surfels"])
            self.assertGreater(row["surfels"], row["max_surfels"] / 3)

        # The medium's scattering is unchanged, and so is the division.
        self.assertEqual([row["divisor"] for row in series["sigma_tr"]], [1, 10, 100])
        self.assertEqual(len({row["surfels"] for row in series["sigma_tr"]}), 1)
        media = [row["medium"] for row in series["sigma_tr"]]
        self.assertEqual([medium["sigma_s_per_mm"] for medium in media], 3 * [{"r": 2.5, "g": 2.5, "b": 2.5}])
        for medium, divisor in zip(media, (1, 10, 100)):
            for channel, sigma_a in (("r", .02), ("g", .01)):
                length = (3 * sigma_a * (sigma_a + 2.5)) ** -.5
                self.assertAlmostEqual(medium["diffusion_length_mm"][channel] / length, divisor, delta=1e-9 * divisor)
            self.assertEqual(medium["sigma_a_per_mm"]["b"], 0)

        self.assertEqual([row["tolerance"] for row in series["tolerance"]],
                         [.1, .03, .01, .003])
        self.assertEqual(found["tolerance"]["finest"], 1e-4)

        frames = {series["varied"]: series for series in found["frames"]}
        values = {varied: [row["value"] for row in series["rows"]] for varied, series in frames.items()}
        self.assertEqual(values["lights"], [1, 2, 4, 8, 16])
        self.assertEqual(values["pixels"], [16 ** 2, 32 ** 2, 64 ** 2])
        self.assertEqual(values["surfels"], [row["surfels"] for row in series["surfels"]])
        # The limits are 64 twice, 256 and 1024.
        for value, most in zip(values["clusters"], (64, 64, 256, 1024)):
            self.assertLessEqual(value, most)
            self.assertGreater(value, most / 4)
        for found_frames in frames.values():
            for time in ("part", "frame"):
                self.assert_fits(found_frames["rows"], time + "_ms", found_frames[time + "_exponent"])
        errors = [row["rel_rmse"] for row in series["tolerance"]]
        evaluations = [row["evaluations"] for row in series["tolerance"]]
        self.assertEqual(errors, sorted(errors, reverse=True))
        self.assertEqual(evaluations, sorted(evaluations))
        for row in series["tolerance"]:
            self.assertLess(row["rel_rmse"], row["tolerance"])
        self.assertIn("<svg", (self.folder / "plot.svg").read_text())

    def test_what_is_open_has_no_clusters(self):
        self.write("t.ply", tetrahedron(1).replace("face 4", "face 3").removesuffix("3 1 2 3\n"))
        order = ("bench", "scaling", "t.ply", "--medium", "marble", "--size", 8, "--frames", 1, "--max-surfels", 16384)
        out = self.succeed(*order).out
        self.assertIn("Frames of better-dipole, as nothing has an inside for boundary transport", out)
        self.assertNotIn("clusters", out)

    def test_tables(self):
        out = self.measure(size=16).out
        for part in ("every budget is too small", "sigma_tr", "1.30", "tolerance", "evaluations",
                     "Frames of boundary transport", "clusters"):
            self.assertIn(part, out)

    def test_refusals(self):
        self.refused(2, "bench", "scaling", "--models", "here", says="bench table1")
        self.refused(2, "bench", "scaling", "--truth", "a.exr", says="bench methods")
        self.refused(2, "bench", "methods", "--max-surfels", 20000, says="bench scaling")
        self.refused(2, "bench", "scaling", "--max-surfels", 16383, says="from 16384 to 4194304")


if __name__ == "__main__":
    unittest.main()
