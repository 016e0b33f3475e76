"""`info` tells what is in a scene."""

import math
import struct
import unittest

from program import CUBE_OBJ, ProgramTest

FIELDS = {"triangles", "vertices", "closed", "boundary_loops", "components", "bounds_min_mm", "bounds_max_mm",
          "clips", "repairs"}


class Info(ProgramTest):
    def test_a_closed_cube(self):
        self.write("cube.obj", CUBE_OBJ)
        info = self.succeed("info", "cube.obj", "--diagonal-mm", "30", "--medium", "skin1", "--json").json()
        self.assertLessEqual(FIELDS, set(info))
        self.assertEqual((info["triangles"], info["vertices"]), (12, 24))
        self.assertTrue(info["closed"], "sides with normals of their own still meet")
        self.assertEqual((info["boundary_loops"], info["components"]), (0, 1))
        edge = 30 / math.sqrt(3)
        for least, most in zip(info["bounds_min_mm"], info["bounds_max_mm"]):
            self.assertAlmostEqual(most - least, edge, delta=1e-4)
        self.assertAlmostEqual(info["diagonal_mm"], 30, delta=1e-4)
        cube, = info["objects"]
        self.assertEqual(cube["medium"]["name"], "skin1")
        self.assertAlmostEqual(cube["medium"]["mean_free_path_mm"]["r"], 1 / (.74 + .032), delta=1e-9)
        for extent in cube["size_mm"]:
            self.assertAlmostEqual(extent, edge, delta=1e-4)
        self.assertNotIn("atlas", info, "it is made only when asked for")

    def test_an_open_one_and_its_repairs(self):
        without_lid = CUBE_OBJ.replace("f 5//2 6//2 7//2 8//2\n", "")
        self.assertNotEqual(without_lid, CUBE_OBJ)
        self.write("box.obj", without_lid + "f 1//3 2//3 6//3 5//3\nf 1 1 2\nv 7 7 7\n")
        run = self.succeed("info", "box.obj", "--json")
        info = run.json()
        self.assertFalse(info["closed"])
        self.assertEqual((info["boundary_loops"], info["components"], info["triangles"]), (1, 1, 10))
        self.assertEqual([entry["triangles_without_inside"] for entry in info["objects"]], [10])
        self.assertTrue(info["repairs"])
        for repair in info["repairs"]:
            self.assertGreater(repair["count"], 0)
        self.assertIn("50 mm", run.err, "a file without a unit is scaled, with a note")
        self.assertEqual(self.succeed("info", "box.obj", "--json", "--quiet").err, "")

    def test_an_open_object_has_no_inside(self):
        self.write("box.obj", "o lidless\n" + CUBE_OBJ.replace("f 5//2 6//2 7//2 8//2\n", ""))
        line, = (line for line in self.succeed("info", "box.obj").out.splitlines() if "is open" in line)
        for part in ("object ", "--transport boundary", "better-dipole"):
            self.assertIn(part, line)
        # Rendering says the same.
        self.assertIn("is open", self.succeed("render", "box.obj", "--size", "8x8", "-o", "a.png").err)
        self.write("cube.obj", CUBE_OBJ)
        closed, = self.succeed("info", "cube.obj", "--json").json()["objects"]
        self.assertEqual(closed["triangles_without_inside"], 0)
        self.assertNotIn("is open", self.succeed("info", "cube.obj").out)

    def test_a_sequence(self):
        for number in (3, 4, 6, 7):
            self.write(f"f_{number:04}.obj", CUBE_OBJ)
        run = self.succeed("info", "f_%04d.obj")
        self.assertIn("\nsequence of 2 files, f_0003.obj to f_0004.obj\n", run.out)
        gap = "f_0005.obj is missing, so the sequence ends with the file before it, although f_0006.obj is there"
        self.assertIn(gap, run.err)
        self.assertEqual(self.succeed("info", "f_%04d.obj", "--json").json()["sequence"],
                         {"files": 2, "first": "f_0003.obj", "last": "f_0004.obj"})
        self.assertIn(gap, self.succeed("render", "f_%04d.obj", "--size", "8x8", "-o", "a.png").err)
        self.write("f_0005.obj", CUBE_OBJ)
        run = self.succeed("info", "f_%04d.obj")
        self.assertIn("sequence of 5 files", run.out)
        self.assertNotIn("missing", run.err)
        self.assertIsNone(self.succeed("info", "f_0003.obj", "--json").json()["sequence"])

    def test_what_was_turned_is_noted(self):
        inward = CUBE_OBJ.splitlines()
        for i, line in enumerate(inward):
            if line.startswith("f "):
                inward[i] = "f " + " ".join(reversed(line.split()[1:]))
        self.write("cube.obj", "\n".join(inward) + "\n")
        said = "cube.obj: 12 triangles faced inwards and were turned outwards"
        for command in (("info",), ("render", "--size", "8x8", "-o", "a.png")):
            self.assertEqual(self.succeed(*command, "cube.obj").err.count(said), 1)

    def test_what_moves(self):
        self.write("cube.obj", CUBE_OBJ)
        self.write("scene.toml", 'model = "cube.obj"\nmorph_to = "cube.obj"\n'
                                 '[[deform]]\nkind = "twist"\namount = 0.5\nperiod_seconds = 2\n')
        info = self.succeed("info", "scene.toml", "--json").json()
        self.assertEqual(info["clips"], [{"name": "morph", "seconds": 4}])
        text = self.succeed("info", "scene.toml").out
        self.assertIn("clip morph: 4 s\n", text)
        self.assertIn("deform twist: 0.5, period 2 s\n", text)

    def test_what_is_not_shown(self):
        cube = ("o pot\nusemtl glaze\n" + CUBE_OBJ).replace("f 5//2", "o lid\nusemtl wood\nf 5//2")
        self.write("cube.obj", cube)
        run = self.succeed("info", "cube.obj", "--json")
        self.assertEqual(run.json()["not_shown"], [
            {"what": "materials", "count": 2, "names": ["glaze", "wood"]},
            {"what": "groups as objects of their own", "count": 2, "names": ["lid", "pot"]}])
        said = "not shown: materials (2: glaze, wood), groups as objects of their own (2: lid, pot)"
        self.assertIn("cube.obj: " + said, run.err)
        self.assertEqual(run.err.count("not shown"), 1)
        self.assertIn("\n" + said + "\n", self.succeed("info", "cube.obj", "--quiet").out)
        self.write("scene.toml", 'model = "cube.obj"\nmedium = "wax"\n')
        self.assertIn(said, self.succeed("info", "scene.toml").err)
        self.write("plain.obj", CUBE_OBJ)
        run = self.succeed("info", "plain.obj", "--json")
        self.assertEqual(run.json()["not_shown"], [])
        self.assertNotIn("not shown", run.err)

    def test_what_a_medium_hides(self):
        self.write("a.mtl", "newmtl red\nKd 0.5 0 0\n")
        self.write("cube.obj", "mtllib a.mtl\nusemtl red\n" + CUBE_OBJ)
        self.assertNotIn("not shown", self.succeed("info", "cube.obj").err)
        run = self.succeed("info", "cube.obj", "--medium", "skin1", "--json")
        self.assertEqual(run.json()["not_shown"], [{"what": "base colours", "count": 1, "names": ["red"]}])
        said = "note: not shown where a medium replaces a material: base colours (1: red)"
        self.assertIn(said, self.succeed("info", "cube.obj", "--medium", "skin1").err)
        self.assertIn(said, self.succeed("render", "cube.obj", "--medium", "skin1@red", "--size", "8x8", "-o", "a.png").err)
        for table in ('medium = "skin1"\n', '[objects.red]\nmedium = "skin1"\n'):
            self.write("scene.toml", 'model = "cube.obj"\n' + table)
            run = self.succeed("info", "scene.toml", "--json")
            self.assertEqual(run.json()["not_shown"], [{"what": "base colours", "count": 1, "names": ["red"]}], table)
            self.assertIn(said, self.succeed("info", "scene.toml").err)

    def test_a_picture_that_is_missing(self):
        self.write("a.mtl", "newmtl red\nmap_Kd none.png\n")
        self.write("cube.obj", "mtllib a.mtl\nusemtl red\n" + CUBE_OBJ)
        run = self.succeed("info", "cube.obj", "--json")
        self.assertEqual(run.json()["not_shown"], [{"what": "textures that cannot be read", "count": 1, "names": ["none.png"]}])
        notes = [line for line in self.succeed("info", "cube.obj").err.splitlines() if "none.png" in line]
        self.assertEqual(len(notes), 1, notes)
        self.assertIn("a texture is left out", notes[0])

    def test_the_built_in_scenes(self):
        bear = self.succeed("info", "--json").json()
        self.assertTrue(bear["closed"])
        self.assertEqual(bear["components"], 1)
        self.assertTrue(40000 < bear["triangles"] < 60000, bear["triangles"])
        self.assertEqual(bear["repairs"], [])
        teapot = self.succeed("info", "--builtin", "teapot", "--json").json()
        self.assertEqual((teapot["triangles"], teapot["vertices"]), (2256, 1177))

    def test_sizes_that_were_hardly_meant_draw_a_note(self):
        # Marble's longest diffusion length is red's: 1 / sqrt(3 * .0021 * (2.19 + .0021)) = 8.51 mm.
        length = 1 / math.sqrt(3 * .0021 * 2.1921)
        self.write("cube.obj", CUBE_OBJ)
        for lengths, word in [(1.9, "fog"), (2.1, None), (990, None), (1010, "opaque")]:
            arguments = ("info", "cube.obj", "--medium", "marble", "--diagonal-mm", lengths * length)
            notes = self.succeed(*arguments).err
            self.assertEqual("diffusion lengths" in notes, word is not None, (lengths, notes))
            if word:
                self.assertIn(word, notes)
            self.assertEqual(self.succeed(*arguments, "--quiet").err, "")
        # Where nothing is absorbed, mean free paths count, and a body may be as large as it likes.
        for paths, noted in [(1.9, True), (2.1, False), (1e5, False)]:
            notes = self.succeed("info", "cube.obj", "--sigma-s", 2, "--sigma-a", 0, "--diagonal-mm", paths / 2).err
            self.assertEqual("mean free paths" in notes and "fog" in notes, noted, (paths, notes))

    def test_a_size_is_that_of_an_object(self):
        self.write("cube.obj", CUBE_OBJ)
        cubes = "".join(f'[[models]]\nfile = "{name}.obj"\ndiagonal_mm = {mm}\ntranslation_mm = [{place}, 0, 0]\n'
                        for name, mm, place in (("cube", 100, 0), ("pea", 9, 200), ("grain", 6, 300)))
        for name in ("pea", "grain"):
            self.write(f"{name}.obj", CUBE_OBJ)
        self.write("scene.toml", 'medium = "marble"\n' + cubes)
        notes = self.succeed("info", "scene.toml").err.splitlines()
        self.assertEqual(len(notes), 1, notes)
        for said in ("object grain measures 6 mm, 0.705 diffusion lengths of marble", "as will 1 more"):
            self.assertIn(said, notes[0])

    def test_the_text_says_the_same(self):
        self.write("cube.obj", CUBE_OBJ)
        text = self.succeed("info", "cube.obj", "--diagonal-mm", "30").out
        for part in ("cube: 12 triangles", "closed", "1 component\n", "diagonal 30 mm", "mean free path", "evice"):
            self.assertIn(part, text)
        self.assertNotIn("atlas", text)

    def test_a_length_is_in_millimetres_however_large_or_small(self):
        self.write("sheet.obj", "v 0 0 0\nv 3 0 0\nv 3 4 0.0000001\nf 1 2 3\n")
        text = self.succeed("info", "sheet.obj", "--diagonal-mm", 5000).out
        self.assertIn("sheet: 1 triangle, 3 vertices, open (1 boundary loop), 1 component\n"
                      "from 0, 0, 0 mm to 3000, 4000, 0 mm, diagonal 5000 mm\n", text)
        self.assertIn("object sheet: 3000 x 4000 x 0.0001 mm of marble", text)
        text = self.succeed("info", "sheet.obj", "--diagonal-mm", .005).out
        self.assertIn("to 0.003, 0.004, 0 mm, diagonal 0.005 mm\n", text)

    def test_light_that_never_fades_has_no_diffusion_length(self):
        text = self.succeed("info", "--sigma-s", "1,1,1", "--sigma-a", "0,0,0").out
        self.assertIn("mean free path 1 1 1 mm, diffusion length infinite\n", text)
        text = self.succeed("info", "--sigma-s", "1,1,1", "--sigma-a", "0,0,1").out
        self.assertIn("diffusion length infinite infinite 0.408 mm\n", text)  # 1 / sqrt(3 * 1 * 2)

    def test_the_picture_of_the_atlas(self):
        self.write("cube.obj", CUBE_OBJ)
        run = self.succeed("info", "cube.obj", "--atlas", "atlas.png", "--json")
        self.assertIn("wrote atlas.png", run.err)
        atlas = run.json()["atlas"]
        self.assertGreater(atlas["charts"], 0)
        self.assertTrue(0 < atlas["coverage"] <= 1)
        self.assertLess(atlas["area_distortion_rms"], .05)
        self.assertIn("atlas: ", self.succeed("info", "cube.obj", "--atlas", "atlas.png").out)
        data = (self.folder / "atlas.png").read_bytes()
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", data[16:24]), (1024, 1024))


if __name__ == "__main__":
    unittest.main()
