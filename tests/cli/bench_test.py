"""`bench`: what its suites ask for and what they tell."""

import os
import unittest

from program import ProgramTest

ROW = {"data", "triangles", "vertices", "ftf_fps", "vtf_fps", "paper_ftf_fps", "paper_vtf_fps", "tree_fps"}
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
        # Stand-ins, as small as can be: the table is the same.
        models = self.folder / "models"
        models.mkdir()
        for name in FILES:
            (models / name).write_text(tetrahedron(2 if name == "bunny_egg_b.ply" else 1))
        run = self.succeed("bench", "table1", "--frames", 1, "--models", "models", "--json")
        table = run.json()
        self.assertEqual(set(table), {"device", "rows"})
        self.assertEqual(set(table["device"]), {"name", "type", "driver"})
        self.assertEqual([(row["data"], row["paper_ftf_fps"], row["paper_vtf_fps"]) for row in table["rows"]], PAPER)
        for row in table["rows"]:
            self.assertEqual(set(row), ROW)
            self.assertEqual(row["triangles"], 4)
            self.assertGreater(row["ftf_fps"], 0)
            self.assertGreater(row["vtf_fps"], 0)
            self.assertIsNone(row["tree_fps"])


class Methods(ProgramTest):
    def test_rows(self):
        self.write("t.ply", tetrahedron(1))
        # Even light, so that a few triangles with smooth normals are lit alike by all.
        scene = ("t.ply", "--diagonal-mm", 10, "--medium", "marble", "--ambient", "1,1,1")
        view = ("--aov", "exitance", "--size", "24x24", "-o", "truth.exr")
        self.succeed("reference", "--path", "--samples", 20000, *scene, *view)
        run = self.succeed("bench", "methods", *scene, "--size", 24, "--frames", 1, "--truth", "truth.exr",
                           "--plot", "plot.svg", "--json")
        rows = run.json()["rows"]
        self.assertEqual([(row["transport"], row["sum"], row["site"]) for row in rows],
                         [(transport, *way) for transport in ("dipole", "better-dipole")
                          for way in (("pattern", "vertex"), ("pattern", "fragment"), ("all", "vertex"),
                                      ("all", "fragment"), ("integral", "exact"))])
        for row in rows:
            self.assertGreater(row["truth_block_rel_rmse"], 0)
            if row["sum"] == "all" and row["site"] == "fragment":
                self.assertLess(row["integral_rel_rmse"], .05)
        self.assertIn("<svg", (self.folder / "plot.svg").read_text())
        self.assertIn("better-dipole", (self.folder / "plot.svg").read_text())

    def test_refusals(self):
        self.refused(2, "bench", "methods", "--models", "here", says="--models")
        self.refused(2, "bench", "table1", "--size", 9, says="bench methods")
        for option in (("t.ply",), ("--medium", "marble"), ("--sigma-s", "1,1,1"), ("--ambient", "1,1,1"),
                       ("--fov-degrees", 20)):
            self.refused(2, "bench", "table1", *option, says="bench methods")
        self.refused(2, "bench", says=("table1", "methods"))
        self.write("t.ply", tetrahedron(1))
        self.succeed("reference", "--path", "--samples", 10, "t.ply", "--size", "8x8", "--aov", "exitance", "-o", "a.exr")
        self.refused(2, "bench", "methods", "t.ply", "--truth", "a.exr", says=("--truth", "8 x 8"))
        # The truth of another view.
        self.refused(2, "bench", "methods", "t.ply", "--size", 8, "--truth", "a.exr", "--fov-degrees", 90,
                     says=("--truth", "reference --path"))


if __name__ == "__main__":
    unittest.main()
