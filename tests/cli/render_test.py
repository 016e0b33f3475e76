"""`render`: the effect of each option on the picture, against values known on paper."""

import json
import math
import unittest

from images import read_exr, read_png
from program import CUBE_OBJ, ProgramTest

REPORT = {"device", "size", "transport", "sum", "site", "triangles", "vertices", "sources", "clusters",
          "solutions", "passes", "frame_ms", "dispatches", "barriers", "recordings", "peak_memory_mb", "outputs", "exposure_stops"}
DIAGONAL = 30
EDGE = DIAGONAL / math.sqrt(3)
# Marble's boundary at normal incidence, eta 1.5: 1 - ((1.5 - 1) / (1.5 + 1))^2.
ENTERING = .96
# A cube whose centre is not at the origin, of a medium that lets no light through.
BODY = ("cube.obj", "--diagonal-mm", DIAGONAL, "--medium", "marble", "--size", "64x48",
        "--shadow-size", 256, "--quiet")
# With few sources, except for the pattern.
CUBE = (*BODY, "--max-surfels", 4096)
LOUD = tuple(part for part in CUBE if part != "--quiet")
PATTERN = (*BODY, "--sum", "pattern", "--dsm-size", 128)


class Render(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("cube.obj", CUBE_OBJ)

    def exr(self, *arguments, body=CUBE):
        self.succeed("render", *body, *arguments, "-o", "out.exr")
        return read_exr((self.folder / "out.exr").read_bytes())

    def png(self, *arguments):
        self.succeed("render", *CUBE, *arguments, "-o", "out.png")
        return read_png((self.folder / "out.png").read_bytes())

    def near(self, got, wanted, relative):
        for a, b in zip(got, wanted, strict=True):
            self.assertAlmostEqual(a, b, delta=relative * max(map(abs, wanted)))


class Outputs(Render):
    def test_what_the_pattern_cannot_light_is_named(self):
        self.refused(2, "render", *PATTERN, "--ground", "-o", "a.png", says="object 'ground' is opaque")

    def test_the_built_in_bear(self):
        run = self.succeed("render", "--size", "128x96")
        self.assertEqual(run.out, "")
        self.assertIn("bear.png", run.err)
        self.assertEqual(self.listing(), ["bear.png", "cube.obj"])
        picture = read_png((self.folder / "bear.png").read_bytes())
        self.assertEqual((picture.width, picture.height), (128, 96))
        share = len(picture.covered()) / (128 * 96)
        self.assertTrue(.1 < share < .6, share)
        inside = [max(pixel[:3]) for pixel in picture.pixels() if pixel[3] == 255]
        self.assertGreater(min(inside), 0, "light comes through everywhere")
        self.assertGreater(sum(inside) / len(inside), 40)

    def test_what_is_seen_edge_on_is_said(self):
        self.write("floor.obj", "v -1 0 -1\nv -1 0 1\nv 1 0 1\nv 1 0 -1\nf 1 2 3 4\n")
        floor = ("floor.obj", "--diagonal-mm", DIAGONAL, "--size", "32x32", "--max-surfels", 4096)
        self.assertIn("the camera sees nothing of the scene", self.succeed("render", *floor).err)
        self.assertNotIn("sees nothing", self.succeed("render", *floor, "--camera-direction", "0.2,0.6,1").err)

    def test_a_ground_with_or_without_its_colour(self):
        above = ("--camera-direction", "0,1,0.01", "--directional", "0,1,0:2", "--bounces", 0)
        for given, share in [(("--ground",), (.5, .5, .5)), (("--ground", ".25"), (.25, .25, .25)),
                             (("--ground", "1,.5,0"), (1, .5, 0))]:
            corner = self.exr(*above, *given).rows[0][0]
            self.near(corner[:3], [2 * part / math.pi for part in share], .005)
            self.assertEqual(corner[3], 1)
        self.refused(2, "render", *BODY, "--ground", "--method", "paper", "-o", "out.exr", says=["ground"])

    def test_the_name_follows_the_scene(self):
        self.assertEqual(self.succeed("render", *CUBE).err, "")
        self.succeed("render", *CUBE, "--aov", "depth")
        self.assertEqual(self.listing(), ["cube.exr", "cube.obj", "cube.png"])

    def test_report(self):
        run = self.succeed("render", *BODY, "--json", "--report", "r.json", "-o", "a.png", "--method", "paper",
                           "--dsm-size", 128)
        report = run.json()
        self.assertEqual(report, json.loads((self.folder / "r.json").read_text()))
        self.assertEqual(set(report), REPORT)
        self.assertEqual(set(report["device"]), {"name", "type", "driver"})
        self.assertIn(report["device"]["type"], ("discrete", "integrated", "virtual", "software"))
        self.assertEqual(report["size"], [64, 48])
        self.assertEqual((report["transport"], report["sum"], report["site"]), ("dipole", "pattern", "fragment"))
        self.assertEqual((report["triangles"], report["outputs"]), (12, ["a.png"]))
        self.assertTrue(0 < report["sources"] <= 128 * 128)
        self.assertEqual((report["clusters"], report["solutions"]), (0, []))
        self.assertTrue(report["passes"])
        for entry in report["passes"]:
            self.assertTrue(entry["name"] and entry["ms"] >= 0, entry)
        self.assertGreater(report["frame_ms"], 0)
        self.assertTrue(0 < report["barriers"] <= report["dispatches"] + 50, report)
        self.assertGreater(report["peak_memory_mb"], 0)

    def test_how_the_body_was_solved_is_reported(self):
        for asked, bounces in (((), 2), (("--bounces", 0), 0), (("--transport", "boundary", "--bounces", 1), 1)):
            report = self.succeed("render", *CUBE, *asked, "--json", "-o", "a.png").json()
            self.assertEqual((report["transport"], report["sum"]), ("boundary", "tree"))
            self.assertTrue(0 < report["clusters"] <= report["sources"])
            # One solution for light from outside, and one for each bounce.
            self.assertEqual(len(report["solutions"]), 1 + bounces)
            for solution in report["solutions"]:
                self.assertEqual(set(solution), {"steps", "residual"})
                self.assertGreaterEqual(solution["steps"], 0)
                self.assertEqual(len(solution["residual"]), 3)
                for residual in solution["residual"]:
                    # The default tolerance of the tree, or what little is left.
                    self.assertTrue(0 <= residual <= .01, solution)
            self.assertGreater(report["solutions"][0]["steps"], 0)

    def test_the_unknowns_keep_to_their_budget(self):
        found = [self.succeed("render", *CUBE, "--max-clusters", most, "--json").json()["clusters"]
                 for most in (100, 1000)]
        self.assertTrue(0 < found[0] <= 100 < found[1] <= 1000, found)

    def test_the_pattern_alone_is_the_papers(self):
        report = self.succeed("render", *PATTERN, "--json", "-o", "a.png").json()
        self.assertEqual((report["transport"], report["sum"]), ("dipole", "pattern"))
        self.write("scene.toml", 'model = "cube.obj"\n[render]\nsum = "pattern"\nsize = [8, 8]\n')
        self.assertEqual(self.succeed("render", "scene.toml", "--json").json()["transport"], "dipole")
        again = self.succeed("render", "scene.toml", "--sum", "tree", "--max-surfels", 4096, "--json").json()
        self.assertEqual((again["transport"], again["sum"]), ("boundary", "tree"))
        self.refused(2, "render", "scene.toml", "--transport", "boundary", says=("--transport boundary", "--sum tree"))
        self.write("scene.toml", 'model = "cube.obj"\n[render]\ntransport = "boundary"\n')
        self.refused(2, "render", "scene.toml", "--sum", "pattern", says=("--sum pattern", "--transport dipole"))

    def test_the_solver_follows_the_tolerance_whatever_the_sum(self):
        few = ("--sum", "all", "--max-surfels", 1024, "--aov", "exitance")
        rough, fine = (self.exr(*few, "--tolerance", tolerance, body=BODY) for tolerance in (1, .0001))
        self.assertNotEqual(list(rough.pixels()), list(fine.pixels()))

    def test_every_method_is_what_the_report_says(self):
        for transport in ("dipole", "better-dipole", "boundary"):
            for total in ("pattern", "tree", "all"):
                if (transport, total) == ("boundary", "pattern"):
                    continue
                for site in ("vertex", "fragment"):
                    asked = {"transport": transport, "sum": total, "site": site}
                    options = [part for name, value in asked.items() for part in (f"--{name}", value)]
                    # Summing over all surfels takes long if there are many.
                    few = ("--dsm-size", 128) if total == "pattern" else ("--max-surfels", 1024)
                    report = self.succeed("render", *BODY, *options, *few, "--json", "-o", "a.png").json()
                    self.assertEqual({name: report[name] for name in asked}, asked)

    def test_site_auto_looks_at_the_edges(self):
        # The cube's edges of 17 mm are longer than any mean free path of marble, the bear's are not
        # longer than one of 100 mm.
        few = ("--max-surfels", 1024)
        self.assertEqual(self.succeed("render", *BODY, *few, "--json").json()["site"], "fragment")
        bear = self.succeed("render", "--size", "16x16", *few, "--sigma-s", ".01,.01,.01",
                            "--sigma-a", "0,0,0", "--json").json()
        self.assertEqual(bear["site"], "vertex")

    def test_exr_reports_coverage_and_linear_radiance(self):
        picture = self.exr()
        self.assertEqual(picture.at(0, 0)[3], 0)
        self.assertEqual(picture.centre()[3], 1)

    def test_devices(self):
        devices = self.succeed("info", "cube.obj", "--json").json()["devices"]
        name = devices[0]["name"]
        for asked in ("0", name, name.upper()):
            report = self.succeed("render", *CUBE, "--transport", "dipole", "--device", asked, "--json").json()
            self.assertEqual(report["device"]["name"], name)
        self.refused(2, "render", *CUBE, "--device", "nosuchdevice", says="nosuchdevice")
        self.refused(2, "render", *CUBE, "--device", "99", says="99")

    def test_the_validation_layer_has_nothing_to_say(self):
        for method in (CUBE, PATTERN, (*BODY, "--sum", "all", "--max-surfels", 1024), (*CUBE, "--transport", "dipole")):
            run = self.succeed("render", *method, "--validation",
                               "--point", "0,0,20:1,1,1", "--directional", "1,1,1", "--ambient", "1,1,1")
            self.assertEqual(run.err, "")


class Geometry(Render):
    def test_normal_position_depth_object(self):
        front = EDGE  # the cube is scaled about the origin
        self.near(self.exr("--aov", "normal").centre(), (0, 0, 1, 1), 1e-4)
        position = self.exr("--aov", "position").centre()
        # Pixel (32, 24) looks half a pixel right of and below the centre.
        distance = 1.4 * DIAGONAL - EDGE / 2
        half_pixel = distance * math.tan(math.radians(15)) / 48
        centre = EDGE / 2
        self.near(position, (centre + half_pixel, centre - half_pixel, front, 1), 1e-3)
        self.near(self.exr("--aov", "depth").centre(), (distance,) * 3 + (1,), 1e-4)
        self.near(self.exr("--aov", "object").centre(), (0, 0, 0, 1), 1e-6)

    def test_surfels(self):
        whole = self.exr("--aov", "surfels", "--validation")
        self.assertEqual({(pixel[1] >= 0, pixel[3]) for pixel in whole.covered()}, {(True, 1)})
        surfels = {pixel[0] for pixel in whole.covered()}
        self.assertTrue(all(index >= 0 and index == int(index) for index in surfels))
        # The front is a sixth of the surface.
        report = self.succeed("render", *CUBE, "--aov", "surfels:0", "--json", "-o", "root.exr").json()
        self.assertLessEqual(len(surfels), report["sources"] / 5)
        self.assertLess(max(surfels), report["sources"])
        self.assertLess(max(pixel[1] for pixel in whole.covered()), report["clusters"])
        root = read_exr((self.folder / "root.exr").read_bytes())
        self.assertEqual({pixel[2] for pixel in root.covered()}, {0})
        self.assertGreater(len({pixel[2] for pixel in self.exr("--aov", "surfels:2").covered()}), 2)
        half_space = self.exr("--aov", "surfels", "--transport", "dipole")
        self.assertEqual([(pixel[0], -1) for pixel in whole.covered()], [pixel[:2] for pixel in half_space.covered()])

    def test_camera(self):
        self.near(self.exr("--aov", "normal", "--camera-direction", "-5,0,0").centre(), (-1, 0, 0, 1), 1e-4)
        wide = len(self.exr("--aov", "normal", "--fov-degrees", "60").covered())
        narrow = len(self.exr("--aov", "normal", "--fov-degrees", "30").covered())
        expected = (math.tan(math.radians(30)) / math.tan(math.radians(15)))**2
        self.assertAlmostEqual(narrow / wide / expected, 1, delta=.15)

    def test_the_whole_bear_is_in_the_picture(self):
        self.succeed("render", "--aov", "depth", "--max-surfels", 1024, "--size", "96x96", "-o", "bear.exr")
        picture = read_exr((self.folder / "bear.exr").read_bytes())
        edge = [*picture.rows[0], *picture.rows[-1], *(row[x] for row in picture.rows for x in (0, -1))]
        self.assertFalse(any(pixel[3] for pixel in edge))
        self.assertGreater(len(picture.covered()), .15 * 96 * 96)

    def test_a_direction_keeps_the_distance_of_the_scenes_camera(self):
        self.write("near.toml", 'model = "cube.obj"\ndiagonal_mm = 30\n[camera]\nposition_mm = [0, 0, 40]\n')
        arguments = ("--aov", "depth", "--max-surfels", 1024, "--size", "16x15")
        for turned in ((), ("--camera-direction", "0,0,-7"), ("--camera-direction", "3,0,0")):
            self.succeed("render", "near.toml", *arguments, *turned, "-o", "near.exr")
            centre = read_exr((self.folder / "near.exr").read_bytes()).centre()
            self.near(centre, (40 - EDGE / 2,) * 3 + (1,), 1e-4)

    def border_and_depth(self, *arguments):
        """Whether anything touches the picture's border, and the depth in its middle, mm."""
        self.succeed("render", *arguments, "--aov", "depth", "--transport", "dipole", "--max-surfels", 1024, "-o", "d.exr")
        return self.border_of("d.exr")

    def border_of(self, name):
        picture = read_exr((self.folder / name).read_bytes())
        edge = [*picture.rows[0], *picture.rows[-1], *(row[x] for row in picture.rows for x in (0, -1))]
        return any(pixel[3] for pixel in edge), picture.centre()[0]

    def test_a_camera_that_nobody_placed_sees_all(self):
        # A plate on edge: its corners are half a diagonal up, nearer by half its depth.
        self.write("plate.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                   "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                   "0 0 0\n0 4 0\n0 4 3\n0 0 3\n4 0 1 2 3\n")
        plate = ("plate.ply", "--diagonal-mm", 50)
        side = (*plate, "--size", "101x101", "--camera-direction", "1,0,0")
        # From the side its upper edge is 20 mm up: at .97 of the half height from 20 / (.97 tan 15) mm.
        cut, depth = self.border_and_depth(*side)
        self.assertEqual((cut, round(depth, 3)), (False, round(20 / (.97 * math.tan(math.radians(15))), 3)))
        # In a narrow picture it is the 15 mm to the side.
        narrow = ("--size", "51x151", "--camera-direction", "1,0,0")
        expected = 15 * 151 / 51 / (.97 * math.tan(math.radians(15)))
        self.assertEqual(self.border_and_depth(*plate, *narrow)[0], False)
        self.assertAlmostEqual(self.border_and_depth(*plate, *narrow)[1], expected, delta=1e-3 * expected)
        # In a wide field of view, or where it was placed, it stays.
        for chosen, place in ((("--fov-degrees", 30), 70), (("--camera-target", "0,0,0"), 70)):
            cut, depth = self.border_and_depth(*side, *chosen)
            self.assertTrue(cut)
            self.assertAlmostEqual(depth, place, delta=1e-3)
        cut, depth = self.border_and_depth(*side[:-2], "--camera-position", "40,0,0")
        self.assertAlmostEqual(depth, 40, delta=1e-3)
        # A cube's front is in the picture from 1.4 diagonals.
        self.write("cube.obj", CUBE_OBJ)
        cut, depth = self.border_and_depth("cube.obj", "--diagonal-mm", 50, "--size", "101x101")
        self.assertAlmostEqual(depth, 70 - 25 / math.sqrt(3), delta=1e-3)

    def test_a_film_has_one_frame_for_all_its_motion(self):
        self.write("cube.obj", CUBE_OBJ)
        cube = ("cube.obj", "--diagonal-mm", 50, "--size", "101x101", "--deform", "squash:-.9:1")
        self.succeed("render", *cube, "--aov", "depth", "--transport", "dipole", "--max-surfels", 1024,
                     "--frames", "0:2", "--fps", 4, "-o", "f%d.exr")
        rest, stretched, again = (self.border_of(f"f{n}.exr") for n in range(3))
        self.assertFalse(rest[0] or stretched[0] or again[0])
        self.assertAlmostEqual(rest[1], again[1], delta=1e-3)
        # 1.9 times as high from its foot on, seen above its front, which is 1 / sqrt(1.9) times as deep.
        half = 25 / math.sqrt(3)
        front = 2.8 * half / (.97 * math.tan(math.radians(15)))
        self.assertAlmostEqual(stretched[1], front, delta=1e-3 * front)
        self.assertAlmostEqual(rest[1], front + half / math.sqrt(1.9) - half, delta=1e-3 * front)
        still = self.border_and_depth(*cube, "--time", 0)
        self.assertAlmostEqual(still[1], 70 - half, delta=1e-3)

    def test_what_a_camera_looks_at(self):
        self.write("cube.obj", CUBE_OBJ)
        cube = ("cube.obj", "--diagonal-mm", 50, "--size", "101x101")
        half = 25 / math.sqrt(3)
        for where in (("--camera-position", "10,0,60", "--camera-target", "10,0,0"),
                      ("--camera-target", "10,0,0", "--camera-direction", "0,0,2", "--fov-degrees", 20)):
            depth = self.border_and_depth(*cube, *where)[1]
            self.assertAlmostEqual(depth, (60 if "10,0,60" in where else 70) - half, delta=1e-3)
        self.refused(2, "render", *cube, "--camera-position", "0,0,9", "--camera-direction", "0,0,1",
                     says="exclude each other")
        self.refused(2, "render", *cube, "--camera-position", "0,0,0", says="same place")

    def test_the_diffusion_source_map_holds_the_whole_surface(self):
        area = self.exr("--aov", "dsm-area", "--dsm-size", 128, body=BODY)
        self.assertEqual((area.width, area.height), (128, 128))
        total = sum(pixel[0] for pixel in area.covered())
        self.assertAlmostEqual(total / (6 * EDGE**2), 1, delta=.03)
        for normal in self.exr("--aov", "dsm-normal", "--dsm-size", 128, body=BODY).covered():
            self.assertAlmostEqual(math.hypot(*normal[:3]), 1, delta=1e-3)


class Light(Render):
    """These options work with any transport; this one is quick."""

    def exr(self, *arguments):
        return super().exr("--transport", "dipole", *arguments)

    def test_directional(self):
        light = ("--directional", "0,0,5:1,2,3", "--aov", "irradiance")
        self.near(self.exr(*light).centre()[:3], (ENTERING, 2 * ENTERING, 3 * ENTERING), 2e-3)
        self.near(self.exr(*light, "--directional", "0,0,1").centre()[:3],
                  (2 * ENTERING, 3 * ENTERING, 4 * ENTERING), 2e-3)
        self.near(self.exr("--directional", "0,0,-1", "--aov", "irradiance").centre()[:3], (0, 0, 0), 0)

    def test_point(self):
        height = 25
        picture = self.exr("--point", f"0,0,{EDGE / 2 + height}:100,200,400", "--aov", "irradiance")
        wanted = [intensity / height**2 * ENTERING for intensity in (100, 200, 400)]
        self.near(picture.centre()[:3], wanted, 3e-3)

    def test_ambient(self):
        # 2 times the integral of F_t mu over mu at eta 1.5 is .908.
        picture = self.exr("--ambient", "1,2,0", "--aov", "irradiance")
        self.near(picture.centre()[:3], (math.pi * .908, 2 * math.pi * .908, 0), 2e-3)

    def test_the_most_light_that_there_may_be(self):
        for light in (("--ambient", "1e30"), ("--directional", "0,0,1:1e30"), ("--point", "0,0,100:1e30")):
            most = max(max(pixel[:3]) for pixel in self.exr(*light, "--aov", "irradiance").pixels())
            self.assertTrue(1e25 < most < 1e31, (light, most))

    def test_only_what_is_given_shines(self):
        for pixel in self.exr("--ambient", "0,0,0").pixels():
            self.assertEqual(pixel[:3], (0, 0, 0))

    def test_radiance_is_linear_in_the_light(self):
        once = self.exr("--directional", "1,1,2:1,1,1", "--no-specular").centre()
        thrice = self.exr("--directional", "1,1,2:3,3,3", "--no-specular").centre()
        self.assertGreater(min(once[:3]), 0)
        self.near(thrice[:3], [3 * value for value in once[:3]], 2e-3)

    def test_environment(self):
        # A uniform Radiance file of value 1: mantissa 128, exponent 129.
        self.write("white.hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n" +
                   bytes([128, 128, 128, 129]) * (8 * 16))
        picture = self.exr("--environment", "white.hdr", "--aov", "irradiance")
        self.near(picture.centre()[:3], (math.pi * .908,) * 3, 1e-2)


class Look(Render):
    LIGHT = ("--directional", "0,0,1:.4,.4,.4", "--no-specular")

    def exr(self, *arguments):
        return super().exr("--transport", "dipole", *arguments)

    def png(self, *arguments):
        return super().png("--transport", "dipole", *arguments)

    def linear(self, *arguments):
        """The centre of a PNG, decoded (IEC 61966-2-1)."""
        values = [v / 255 for v in self.png(*self.LIGHT, *arguments).centre()[:3]]
        return [v / 12.92 if v <= .04045 else ((v + .055) / 1.055)**2.4 for v in values]

    def test_exposure_is_in_stops_and_no_tone_curve_keeps_the_values(self):
        radiance = self.exr(*self.LIGHT).centre()[:3]
        self.near(self.linear("--tone", "none", "--exposure", "0"), radiance, .02)
        self.near(self.linear("--tone", "none", "--exposure", "1"), [2 * v for v in radiance], .02)
        self.assertNotEqual(self.linear("--tone", "none", "--exposure", "3"),
                            self.linear("--tone", "neutral", "--exposure", "3"))

    def test_exposure_follows_the_light_unless_it_is_given(self):
        def made(name, *arguments):
            run = self.succeed("render", *LOUD, "--ambient", "20,20,20", *arguments, "-o", name)
            return run, (self.folder / name).read_bytes()

        # Three stops above the brightest light that is left as it is.
        followed, picture = made("followed.png", "--report", "report.json")
        self.assertIn("exposure set to -3 stops", followed.err)
        self.assertEqual(json.loads((self.folder / "report.json").read_text())["exposure_stops"], -3)
        told, same = made("told.png", "--exposure", "-3")
        self.assertNotIn("exposure", told.err)
        self.assertEqual(picture, same)
        linear, _ = made("linear.exr", "--report", "report.json")
        self.assertNotIn("exposure", linear.err)
        self.assertIsNone(json.loads((self.folder / "report.json").read_text())["exposure_stops"])

    def test_background(self):
        self.assertEqual(self.png().at(0, 0)[3], 0)
        self.assertEqual(self.png("--background", "1,0,0", "--tone", "none").at(0, 0), (255, 0, 0, 255))

    def test_antialiasing_softens_edges(self):
        hard = {pixel[3] for pixel in self.png("--antialias", 1, "--camera-direction", "1,2,3").pixels()}
        soft = {pixel[3] for pixel in self.png("--antialias", 8, "--camera-direction", "1,2,3").pixels()}
        self.assertEqual(hard, {0, 255})
        self.assertGreater(len(soft), 4)

    def test_the_surface_reflects(self):
        light = ("--directional", "0,0,1:1,1,1")
        plain = self.exr(*light, "--no-specular").centre()
        shiny = self.exr(*light).centre()
        self.assertGreater(shiny[0], plain[0] * 1.2)
        self.assertNotEqual(self.exr(*light, "--roughness", 1).centre(), shiny)


class SceneFiles(Render):
    def test_settings_of_the_file_and_options_over_them(self):
        self.write("scene.toml", 'model = "cube.obj"\ndiagonal_mm = 30\n'
                   '[render]\nsize = [40, 30]\ntransport = "better-dipole"\nsite = "vertex"\ndsm_size = 64\n')
        report = self.succeed("render", "scene.toml", "--json").json()
        self.assertEqual((report["size"], report["transport"], report["site"], report["outputs"]),
                         ([40, 30], "better-dipole", "vertex", ["scene.png"]))
        report = self.succeed("render", "scene.toml", "--json", "--size", "20x10", "--site", "fragment").json()
        self.assertEqual((report["size"], report["transport"], report["site"]),
                         ([20, 10], "better-dipole", "fragment"))
        self.write("scene.toml", 'model = "cube.obj"\n[render]\nsize = "36x24"\nmax_surfels = 4096\n')
        self.assertEqual(self.succeed("render", "scene.toml", "--json").json()["size"], [36, 24])
        self.write("scene.toml", 'model = "cube.obj"\n[render]\nsize = [8, 8]\ntransport = "boundary"\nsum = "tree"\n'
                   'bounces = 1\nmax_clusters = 200\nmax_surfels = 4096\n')
        report = self.succeed("render", "scene.toml", "--json").json()
        self.assertEqual((report["transport"], report["sum"], len(report["solutions"])), ("boundary", "tree", 2))
        self.assertLessEqual(report["clusters"], 200)
        report = self.succeed("render", "scene.toml", "--bounces", 3, "--max-clusters", 64, "--json").json()
        self.assertEqual(len(report["solutions"]), 4)
        self.assertLessEqual(report["clusters"], 64)

    def test_what_a_picture_depends_on_can_stand_in_the_file(self):
        said = ("--transport", "dipole", "--size", "24x16", "--diagonal-mm", 30)
        options = {"--background": ("1,0.5,0", "background = [1, 0.5, 0]"),
                   "--max-surfels": ("1024", "max_surfels = 1024"),
                   "--tolerance": ("1", "tolerance = 1")}
        self.succeed("render", "cube.obj", *said, "-o", "plain.png")
        for option, (value, key) in options.items():
            self.write("scene.toml", 'model = "cube.obj"\ndiagonal_mm = 30\n[render]\ntransport = "dipole"\n'
                       f"size = [24, 16]\n{key}\n")
            self.succeed("render", "cube.obj", *said, option, value, "-o", "option.png")
            self.succeed("render", "scene.toml", "-o", "file.png")
            found = (self.folder / "file.png").read_bytes()
            self.assertEqual(found, (self.folder / "option.png").read_bytes(), option)
            self.assertNotEqual(found, (self.folder / "plain.png").read_bytes(), option)
            self.succeed("render", "scene.toml", option, value, "-o", "both.png")


if __name__ == "__main__":
    unittest.main()
