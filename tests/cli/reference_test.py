"""The reference: it shares options, pixels and variables with render, and refuses the rest."""

import math
import resource
import shutil
import unittest

from images import read_exr, read_png
from program import CUBE_OBJ, ProgramTest

DIAGONAL = 30
EDGE = DIAGONAL / math.sqrt(3)
# Transmittance at normal incidence, 4 eta / (1 + eta)^2, eta 1.5.
ENTERING = 4 * 1.5 / 2.5**2


class Reference(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("cube.obj", CUBE_OBJ)

    SCENE = ("cube.obj", "--diagonal-mm", DIAGONAL, "--medium", "marble", "--size", "12x10")

    def exr(self, command, *arguments):
        self.succeed(command, *self.SCENE, *arguments, "-o", "out.exr")
        return read_exr((self.folder / "out.exr").read_bytes())

    def reference(self, *arguments):
        return self.exr("reference", "--integral", "--tolerance", .01, *arguments)

    def near(self, found, wanted, tolerance):
        for a, b in zip(found, wanted, strict=True):
            self.assertAlmostEqual(a, b, delta=tolerance)


class Pictures(Reference):
    def test_variables_are_at_the_pixels_of_render(self):
        for variable, tolerance in (("position", 2e-3), ("normal", 2e-3), ("depth", 2e-3), ("object", 0)):
            options = ("--aov", variable, "--camera-direction", ".3,.2,1")
            truth = self.reference(*options)
            found = self.exr("render", "--max-surfels", 4096, *options)
            self.assertGreater(len(truth.covered()), 20)
            for a, b in zip(truth.pixels(), found.pixels(), strict=True):
                self.near(a, b, tolerance)

    def test_lights_are_those_of_render(self):
        surfels = ("--max-surfels", 4096)  # each holds one value
        texels = ("--sum", "pattern", "--transport", "dipole")
        for light, gathered in ((("--directional", "0,1,2:1,2,3"), surfels), (("--directional", "0,1,2:1,2,3"), texels),
                                (("--point", "3,0,20:500,300,100"), texels), (("--ambient", "1,.5,0"), surfels),
                                (("--spot", "3,0,20:500,300,100:0,0,-1:5,40"), texels),
                                (("--sphere", "0,0,30:6:1,2,3"), surfels), (("--disc", "0,0,25:0,0,-1:6:1,2,3"), surfels),
                                (("--rectangle", "0,0,25:6,0,0:0,-6,0:1,2,3"), surfels),
                                (("--tube", "0,-9,25:0,9,25:3:1,2,3"), surfels)):
            # Area lights approximate the Fresnel term by two lobes.
            tolerance = 4e-3 if light[0] in ("--directional", "--point", "--spot", "--ambient") else 1e-2
            options = ("--aov", "irradiance", *light)
            found = self.exr("render", *gathered, *options).centre()
            for a, b in zip(self.reference(*options).centre(), found, strict=True):
                self.assertAlmostEqual(a, b, delta=tolerance * b)

    def test_ambient_occlusion_is_that_of_render(self):
        """The reference uses a thousand rays per pixel, render the few of the clusters."""
        scene = ("--builtin", "bear", "--diagonal-mm", 50, "--ambient", 1, "--size", "96x96", "--aov", "irradiance")
        self.succeed("reference", "--integral", "--ambient-occlusion", *scene, "-o", "truth.exr")
        hidden = ((), ("--transport", "better-dipole", "--ambient-occlusion"), ("--method", "paper", "--ambient-occlusion"))
        for method in hidden + (("--method", "paper"),):
            self.succeed("render", *scene, *method, "-o", "found.exr")
            blocks = self.succeed("compare", "found.exr", "truth.exr", "--block", 8, "--json").json()["block"]
            if method in hidden:
                self.assertLess(blocks["covered_rel_rmse"], .025, method)
            else:
                self.assertGreater(blocks["covered_rel_rmse"], .05)

    def test_irradiance_in_the_sun(self):
        self.near(self.reference("--aov", "irradiance", "--directional", "0,0,1:1,2,3").centre()[:3],
                  (ENTERING, 2 * ENTERING, 3 * ENTERING), 1e-6)

    def test_exitance_of_a_large_face_is_nearly_the_total_reflectance(self):
        # The classic dipole's is .83 in red; a cube of 17 mm adds little from its sides, which are dark.
        profile = self.succeed("profile", "--transport", "dipole", "--json").json()["total_reflectance"]
        centre = self.reference("--aov", "exitance", "--directional", "0,0,1").centre()
        self.assertLess(centre[2], ENTERING * profile["b"])
        self.assertGreater(centre[2], .9 * ENTERING * profile["b"])

    def test_transports_differ(self):
        self.assertNotEqual(self.reference("--aov", "exitance").centre(),
                            self.reference("--aov", "exitance", "--transport", "better-dipole").centre())

    def test_bodies_take_a_panel_as_path_tracing_says(self):
        scene = (*self.SCENE[:5], "--size", "64x64", "--aov", "exitance", "--rectangle", "6,9,20:8,0,0:0,-8,4:4")
        self.succeed("render", *scene, "-o", "render.exr")
        self.succeed("reference", "--path", "--samples", 400000, *scene, "-o", "out.exr")
        figures = self.succeed("compare", "render.exr", "out.exr", "--block", 8, "--json").json()
        self.assertLess(abs(figures["rel_bias"]), .03)
        self.assertLess(figures["block"]["covered_rel_rmse"], .1)

    def test_a_region_that_sees_nothing_is_said(self):
        # Without the corner of the picture, the integral of so fine a body would take minutes.
        run = self.succeed("reference", "--builtin", "bear", "--size", "64x64", "--integral", "--tolerance", 1e-5,
                           "--region", "0,0,4,4", "-o", "a.exr")
        self.assertIn("the camera sees nothing of the scene in this --region", run.err)
        self.assertNotIn("estimated error", run.err)
        self.assertEqual(read_exr((self.folder / "a.exr").read_bytes()).covered(), [])

    def test_region_and_every(self):
        whole = self.reference("--aov", "exitance")
        part = self.reference("--aov", "exitance", "--region", "3,2,7,6", "--every", 2)
        for y in range(10):
            for x in range(12):
                inside = 3 <= x < 10 and 2 <= y < 8 and x % 2 == 0 and y % 2 == 0
                self.assertEqual(part.at(x, y), whole.at(x, y) if inside else (0, 0, 0, 0))
        self.assertGreater(len(part.covered()), 2)

    def test_a_png_has_tone_and_coverage(self):
        self.succeed("reference", "--integral", "--tolerance", .01, *self.SCENE, "-o", "out.png")
        picture = read_png((self.folder / "out.png").read_bytes())
        self.assertEqual((picture.width, picture.height), (12, 10))
        self.assertEqual((picture.at(0, 0)[3], picture.centre()[3]), (0, 255))

    def test_time_moves_what_moves(self):
        options = ("--aov", "position", "--deform", "wobble:0.2")
        self.assertNotEqual(self.reference(*options).centre(), self.reference(*options, "--time", .3).centre())
        # A row of files: the second, at 30 a second, is 1 nearer at a scale of 30/sqrt 3.
        for number, shift in ((0, 0), (1, 1)):
            self.write(f"row_{number}.obj", "\n".join(
                f"v {' '.join(line.split()[1:3])} {float(line.split()[3]) + shift}" if line.startswith("v ") else line
                for line in CUBE_OBJ.splitlines()) + "\n")
        depths = []
        for seconds in (0, 1 / 30):
            # A camera that is placed does not step back from what comes nearer.
            self.succeed("reference", "--integral", "row_%d.obj", *self.SCENE[1:], "--aov", "depth",
                         "--camera-target", "0,0,0", "--time", seconds, "-o", "out.exr")
            depths.append(read_exr((self.folder / "out.exr").read_bytes()).centre()[0])
        self.assertAlmostEqual(depths[0] - depths[1], EDGE, delta=1e-3)
        self.refused(2, "reference", "--integral", "row_%d.obj", "--time", 1, says=("--time 1", "row_1.obj"))

    def test_says_what_it_did(self):
        run = self.succeed("reference", "--integral", *self.SCENE, "--tolerance", .01, "--json",
                           "--report", "report.json")
        report = run.json()
        self.assertEqual((self.folder / "report.json").read_text(), run.out)
        self.assertEqual((report["method"], report["size"], report["transport"], report["tolerance"]),
                         ("integral", [12, 10], "dipole", .01))
        self.assertEqual((report["triangles"], report["outputs"]), (12, ["cube.png"]))
        self.assertLessEqual(report["relative_error"]["mean"], report["relative_error"]["max"])
        self.assertLess(report["relative_error"]["p95"], .02)
        self.assertIn("leaves out the reflection", run.err)
        quiet = self.succeed("reference", "--integral", *self.SCENE, "--every", 9, "--quiet")
        self.assertEqual((quiet.out, quiet.err), ("", ""))
        plain = self.succeed("reference", "--integral", *self.SCENE, "--every", 9, "--no-specular")
        self.assertNotIn("reflection", plain.err)

    def test_settings_of_a_scene_file(self):
        self.write("scene.toml", 'model = "cube.obj"\ndiagonal_mm = 30\n[render]\nsize = [8, 6]\n'
                   'transport = "better-dipole"\nantialias = 1\n')
        report = self.succeed("reference", "--integral", "scene.toml", "--every", 3, "--json").json()
        self.assertEqual((report["size"], report["transport"]), ([8, 6], "better-dipole"))


class Paths(Reference):
    SAMPLES = ("--path", "--samples", 3000, "--aov", "exitance", "--directional", "0,0,1")

    def test_same_seed_same_picture_and_another_is_another(self):
        first = self.exr("reference", *self.SAMPLES)
        self.assertEqual(list(first.pixels()), list(self.exr("reference", *self.SAMPLES).pixels()))
        other = self.exr("reference", *self.SAMPLES, "--seed", 2)
        self.assertNotEqual(list(first.pixels()), list(other.pixels()))

    def test_a_checkpoint_goes_on(self):
        whole = self.exr("reference", *self.SAMPLES)
        half = (*self.SAMPLES, "--checkpoint", "state")
        self.exr("reference", "--path", "--samples", 1000, *self.SAMPLES[3:], "--checkpoint", "state")
        self.assertEqual(list(whole.pixels()), list(self.exr("reference", *half).pixels()))
        self.refused(1, "reference", *self.SCENE, *half, "--bounces", 0, says=("state", "other options"))
        self.write("state", "nonsense")
        self.refused(1, "reference", *self.SCENE, *half, says=("state", "no checkpoint"))

    def test_a_checkpoint_without_room_costs_no_picture(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (10000, 10000))
        whole = self.exr("reference", *self.SAMPLES)
        self.refused(1, "reference", *self.SCENE, *self.SAMPLES, "--checkpoint", "state", "-o", "kept.exr", preexec_fn=limit,
                     says=("--checkpoint state", "File too large"))
        self.assertEqual(list(whole.pixels()), list(read_exr((self.folder / "kept.exr").read_bytes()).pixels()))
        self.assertNotIn("state", self.listing())

    def test_says_what_it_did(self):
        run = self.succeed("reference", *self.SCENE, *self.SAMPLES, "--json", "-o", "a.exr")
        report = run.json()
        self.assertIn(f"blocks {report['block_error']:.2g}", run.err)
        self.assertEqual((report["method"], report["particles"]), ("path", 3000))
        self.assertGreater(report["block_error"], 0)
        for channel in range(3):
            left = sum(report["left_flux"][order][channel] for order in ("unscattered", "single", "multiple"))
            self.assertLess(left, report["emitted_flux"][channel])

    def test_an_error_is_reached(self):
        report = self.succeed("reference", *self.SCENE, "--path", "--error", .2, "--aov", "exitance", "--json",
                              "-o", "a.exr").json()
        self.assertLessEqual(report["block_error"], .2)


    def test_an_open_body_is_no_body(self):
        lid = [line for line in CUBE_OBJ.splitlines() if not line.startswith("f 4//1")]
        self.assertEqual(len(CUBE_OBJ.splitlines()) - len(lid), 1)
        self.write("open.obj", "\n".join(lid) + "\n")
        for model, words in (("open.obj", "closed bodies only"), ("cube.obj", None)):
            run = self.succeed("reference", model, *self.SCENE[1:], *self.SAMPLES, "--quiet", "-o", "a.exr")
            self.assertRegex(run.err, f"^warning: .*{words}.*\n$" if words else "^$")

    def test_closed_bodies_that_overlap_have_no_gaps(self):
        self.write("other.obj", CUBE_OBJ.replace("v 0 ", "v 0.5 ").replace("v 1 ", "v 1.5 "))
        run = self.succeed("reference", "cube.obj", "other.obj", *self.SCENE[1:], *self.SAMPLES, "--quiet", "-o", "a.exr")
        self.assertRegex(run.err, "^warning: .* % of the light was lost where bodies overlap.*\n$")
        self.assertNotIn("gaps", run.err)

    def test_darkness_ends(self):
        self.assertEqual(self.exr("reference", "--path", "--aov", "exitance", "--directional", "0,0,1:0,0,0").centre(),
                         (0, 0, 0, 1))


class Films(Reference):
    MOVING = ("--deform", "twist:0.5:2", "--camera-target", "0,0,0")
    METHODS = (("--integral", "--tolerance", .1), ("--path", "--samples", 2000))

    def film(self, *arguments):
        return self.succeed("reference", *self.SCENE, *self.MOVING, *arguments)

    def pixels(self, name):
        return list(read_exr((self.folder / name).read_bytes()).pixels())

    def test_each_frame_is_the_still_of_its_time(self):
        for method in self.METHODS:
            options = (*method, "--aov", "exitance", "--every", 2, "--region", "2,2,8,6")
            self.film(*options, "--frames", "1:3:2", "--fps", 8, "-o", "f%02d.exr")
            self.assertEqual(self.listing(), ["cube.obj", "f01.exr", "f03.exr"])
            for frame in (1, 3):
                self.film(*options, "--time", frame / 8, "-o", "still.exr")
                self.assertEqual(self.pixels(f"f{frame:02}.exr"), self.pixels("still.exr"))
            self.assertNotEqual(self.pixels("f01.exr"), self.pixels("f03.exr"))
            for name in ("f01.exr", "f03.exr", "still.exr"):
                (self.folder / name).unlink()

    def test_a_row_of_files(self):
        for number, shift in ((0, 0), (1, 1)):
            self.write(f"row_{number}.obj", CUBE_OBJ.replace("v 0 0 1", f"v 0 0 {1 + shift / 10}"))
        order = ("reference", "--integral", "row_%d.obj", *self.SCENE[1:], "--aov", "position", "--frames")
        self.succeed(*order, "0:1", "-o", "f%d.exr")
        self.assertNotEqual(self.pixels("f0.exr"), self.pixels("f1.exr"))
        self.refused(2, *order, "0:2", says=("frame 2", "2 files"))

    def test_what_exists_stays(self):
        film = (*self.METHODS[1], "--aov", "exitance", "--frames", "0:2", "-o", "f%d.exr", "--resume")
        self.film(*film)
        before = [self.pixels(f"f{frame}.exr") for frame in range(3)]
        (self.folder / "f1.exr").unlink()
        run = self.film(*film, "--json")
        self.assertIn("2 of 3 frames existed already", run.err)
        self.assertEqual([self.pixels(f"f{frame}.exr") for frame in range(3)], before)
        self.assertEqual([picture["frame"] for picture in run.json()["pictures"]], [1])
        self.assertEqual(run.json()["outputs"], ["f0.exr", "f1.exr", "f2.exr"])
        # Another number of particles, seed or part of the picture is another picture.
        for change in (("--seed", 2), ("--bounces", 3), ("--every", 2), ("--region", "0,0,3,3")):
            self.assertIn("3 of 3 frames came from another", self.film(*film, *change).err)
        self.assertIn("are made again", self.film(*self.METHODS[0], *film[3:]).err)

    def test_parts_of_a_film(self):
        film = (*self.METHODS[1], "--aov", "exitance", "--frames", "0:2", "-o", "f%d.exr")
        for part, frames in ((1, []), (2, [0]), (3, [1]), (4, [2])):
            report = self.film(*film, "--chunk", f"{part}/4", "--json").json()
            self.assertEqual([picture["frame"] for picture in report["pictures"]], frames)
        self.assertEqual(self.listing(), ["cube.obj", "f0.exr", "f1.exr", "f2.exr"])

    def test_a_checkpoint_for_each_frame(self):
        film = ("--path", "--aov", "exitance", "--frames", "0:1", "-o", "f%d.exr")
        self.film(*film, "--samples", 3000)
        whole = [self.pixels(f"f{frame}.exr") for frame in range(2)]
        self.film(*film, "--samples", 1000, "--checkpoint", "state%d")
        self.assertEqual(self.listing(), ["cube.obj", "f0.exr", "f1.exr", "state0", "state1"])
        self.film(*film, "--samples", 3000, "--checkpoint", "state%d")
        self.assertEqual([self.pixels(f"f{frame}.exr") for frame in range(2)], whole)

    def test_says_what_it_did(self):
        run = self.film(*self.METHODS[0], "--frames", "2:4:2", "--fps", 12, "-o", "f%d.png", "--json", "--report", "r.json")
        report = run.json()
        self.assertEqual((self.folder / "r.json").read_text(), run.out)
        self.assertEqual((report["frames"], report["frame_step"], report["fps"]), ([2, 4], 2, 12))
        self.assertEqual([picture["frame"] for picture in report["pictures"]], [2, 4])
        self.assertEqual((report["triangles"], report["pictures"][0]["tolerance"]), (12, .1))
        self.assertIn("wrote 2 frames to f%d.png", run.err)
        still = self.succeed("reference", *self.SCENE, *self.METHODS[0], "--frames", "0:0", "--every", 4)
        self.assertIn("nothing in the scene moves", still.err)
        self.assertIn("cube_0000.png", self.listing())

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_a_film(self):
        run = self.succeed("reference", "cube.obj", "--diagonal-mm", DIAGONAL, "--size", "13x10", *self.MOVING,
                           *self.METHODS[1], "--frames", "0:1", "-o", "film.mp4")
        self.assertIn("this one of 13x10 has 14x10", run.err)
        self.assertEqual((self.folder / "film.mp4").read_bytes()[4:8], b"ftyp")


class Refusals(Reference):
    def test_what_it_cannot_do(self):
        for arguments, says in [
            ((), ("method", "--integral")),
            (("--integral", "--path"), "one method"),
            (("--integral", "--samples", "9"), "belong to --path"),
            (("--integral", "--scattered", "once"), "belong to --path"),
            (("--path", "--scattered", "twice"), "once"),
            (("--integral", "--cone", "20"), "belong to --path"),
            (("--path", "--cone", "90"), "from 0.5 to 60 degrees"),
            (("--path", "--tolerance", ".1"), "belong to --integral"),
            (("--path", "--g", "1"), "from -0.99 to 0.99"),
            (("--integral", "--device", "0"), "--device: the reference runs on the CPU"),
            (("--path", "--device=llvmpipe"), "--device: the reference runs on the CPU"),
            (("--integral", "--frames", "0:3", "--time", "1"), ("--frames", "--time")),
            (("--integral", "--fps", "25"), ("--fps", "--frames")),
            (("--integral", "--resume"), ("--resume", "--frames")),
            (("--integral", "--frames", "0:3", "-o", "a.png"), ("a.png", "%04d")),
            (("--integral", "--frames", "0:3:2", "-o", "a.mp4"), "numbered pictures"),
            (("--path", "--frames", "0:3", "--checkpoint", "state"), ("--checkpoint state", "state_%04d")),
            (("--path", "--checkpoint", "state_%d"), ("--checkpoint state_%d", "--frames")),
            (("--integral", "--roughness", ".3"), ("--roughness", "--no-specular")),
            (("--integral", "--aov", "dsm-area"), ("dsm-*", "render")),
            (("--integral", "--aov", "evaluations"), ("evaluations", "render")),
            (("--integral", "--aov", "surfels:2"), ("surfels", "render")),
            (("--integral", "--sum", "all"), "no option --sum"),
            (("--integral", "--tolerance", "0"), "from 1e-7 to 0.5"),
            (("--integral", "--every", "0"), "from 1 to 16384"),
            (("--integral", "--region", "1,2,3"), "X,Y,WIDTH,HEIGHT"),
            (("--integral", "--region", "1,2,3,4,5"), "--region"),
            (("--integral", "--region", "-1,2,3,4"), ("--region -1,2,3,4", "whole numbers")),
            (("--path", "--samples", "1.5"), ("--samples 1.5", "whole number")),
            (("--path", "--checkpoint", "a/../b.exr", "-o", "b.exr"), ("--checkpoint", "picture would overwrite it")),
            (("--path", "--checkpoint", "b.json", "--report", "b.json"), ("--checkpoint", "report would overwrite it")),
            (("--integral", "-o", "film.mp4"), ("film.mp4", "--frames")),
            (("--integral", "-o", "still_%d.png"), ("still_%d.png", "--frames")),
            (("--integral", "--region", "0,0,13,1"), ("0,0,13,1", "12x10")),
            (("--integral", "--region", "0,0,0,1"), "0,0,0,1"),
            (("--integral", "--clip", "walk"), "no clips"),
        ]:
            with self.subTest(arguments=arguments):
                self.refused(2, "reference", *self.SCENE, *arguments, says=says)
        self.assertEqual(self.listing(), ["cube.obj"])


if __name__ == "__main__":
    unittest.main()
