"""What is not understood is refused with a sentence; help fits a screen."""

import unittest

from program import COMMANDS, CUBE_OBJ, ProgramTest

SCREEN_COLUMNS = 80
SCREEN_LINES = 55


class Help(ProgramTest):
    def test_fits_a_screen(self):
        for arguments in [("--help",), *((command, "--help") for command in COMMANDS)]:
            lines = self.succeed(*arguments).out.splitlines()
            self.assertLessEqual(len(lines), SCREEN_LINES, arguments)
            self.assertLessEqual(max(map(len, lines)), SCREEN_COLUMNS, max(lines, key=len))

    def test_lists_the_commands_there_are_and_no_other(self):
        text = self.succeed("--help").out
        for command in COMMANDS:
            self.assertIn(f"\n  {command} ", text)
        listed = [line.split()[0] for line in text.split("Commands:\n")[1].splitlines() if line.startswith("  ")]
        self.assertEqual(sorted(listed), sorted(COMMANDS))

    def test_comes_before_complaints(self):
        self.assertIn("--medium", self.succeed("render", "--size", "x", "--help").out)

    def test_every_command_can_be_quiet(self):
        for command in COMMANDS:
            self.assertIn("--json, --quiet ", self.succeed(command, "--help").out, command)
        noted = ("profile", "--samples", 2, "--plot", "a.svg")
        self.assertEqual(self.succeed(*noted).err, "note: wrote a.svg.\n")
        self.assertEqual(self.succeed(*noted, "--quiet").err, "")

    def test_version(self):
        self.assertRegex(self.succeed("--version").out, r"^opaline \d+\.\d+\.\d+\n$")


class Refusals(ProgramTest):
    def test_commands(self):
        self.refused(2, says="no command")
        self.refused(2, "rendr", says=("rendr", "did you mean render?"))
        self.refused(2, "xyzzyxyzzy", says="there is no command xyzzyxyzzy;")
        self.refused(2, "", says="there is no command")
        self.refused(1, "info", "", says="Cannot read a file without a name")
        self.refused(2, "render", "--environment", "", says="--environment needs a value, FILE")

    def test_an_unknown_option_suggests_its_neighbour(self):
        for typed, meant in [("--sizee", "--size"), ("--fov", "--fov-degrees"), ("--diagonal-m", "--diagonal-mm"),
                             ("--ouptut", "--output"), ("--repotr=x.json", "--report")]:
            says = ("render has no option", typed.split("=")[0])
            run = self.refused(2, "render", typed, "1", says=says)
            if meant != "--fov-degrees":  # too far from what was typed to guess
                self.assertIn(f"did you mean {meant}?", run.err)
        for command in COMMANDS:
            self.refused(2, command, "--jsom", says="did you mean --json?")

    def test_a_file_that_looks_like_an_option(self):
        self.write("-cube.obj", CUBE_OBJ)
        self.refused(2, "info", "-cube.obj", says="info has no option -cube.obj; the file is ./-cube.obj.")
        self.succeed("info", "./-cube.obj")
        self.succeed("info", "--quiet", "--", "-cube.obj")
        self.refused(1, "info", "--", "-cube.obj", "--quiet", says="Cannot read --quiet")
        self.refused(2, "media", "--", "-cube.obj", says="-cube.obj")

    def test_what_is_nothing_alike_suggests_nothing(self):
        for command, typed in (("view", "--chunk"), ("render", "--resolution"), ("render", "-z")):
            run = self.refused(2, command, typed, "1", says=f"{command} has no option {typed}")
            self.assertNotIn("did you mean", run.err)

    def test_names_of_media_and_objects(self):
        self.refused(2, "render", "--medium", "marbel",
                     says="--medium marbel: there is no medium 'marbel'; did you mean marble? opaline media lists all")
        self.refused(2, "render", "--medium", "xyzzyxyzzy@bear",
                     says="there is no medium 'xyzzyxyzzy'; opaline media lists all")
        self.refused(2, "render", "--medium", "wax@", says="--medium wax@: the name of an object is missing")
        self.refused(2, "render", "--medium", "wax@teapot", says="there is no object 'teapot'; there is only 'bear'")

    def test_a_scene_files_own_media(self):
        """They come before those of the tables, and an error names them too."""
        self.write("cube.obj", CUBE_OBJ)
        self.write("scene.toml", 'model = "cube.obj"\ndiagonal_mm = 20\nmedium = "wax"\n'
                   '[media.jelly]\nsigma_s_per_mm = 3\nsigma_a_per_mm = 0.25\n'
                   '[media.marble]\nmeasured = "ketchup"\n')

        def scattering(scene, *arguments):
            scene = self.succeed("info", scene, *arguments, "--json").json()
            return scene["objects"][0]["medium"]["sigma_s_per_mm"]
        for name in ("jelly", "jelly@cube"):
            self.assertEqual(scattering("scene.toml", "--medium", name), {"r": 3, "g": 3, "b": 3})
        ketchup, marble = (scattering("cube.obj", "--medium", name) for name in ("ketchup", "marble"))
        self.assertEqual(scattering("scene.toml", "--medium", "marble"), ketchup)
        self.assertEqual(scattering("scene.toml", "--medium", "Marble"), marble)
        both = "the scene has jelly, marble, and opaline media lists all others"
        for command in ("render", "view"):
            self.refused(2, command, "scene.toml", "--medium", "jely",
                         says=("--medium jely: there is no medium 'jely'; did you mean jelly?", both))
        self.refused(2, "render", "scene.toml", "--medium", "xyzzyxyzzy@cube",
                     says=f"there is no medium 'xyzzyxyzzy'; {both}")
        self.refused(2, "render", "cube.obj", "--medium", "jelly", says="there is no medium 'jelly'")

    def test_a_field_of_view_of_parallel_lines_of_sight(self):
        self.write("scene.toml", 'model = "builtin:teapot"\n[camera]\northographic_height_mm = 40\n')
        self.refused(2, "render", "scene.toml", "--fov-degrees", 40, says=("--fov-degrees", "orthographic_height_mm"))

    def test_an_extension_in_any_case_is_a_scene_files(self):
        self.write("scene.Toml", 'model = "builtin:teapot"\n')
        self.assertEqual(self.succeed("info", "scene.Toml", "--json").json()["triangles"], 2256)

    def test_what_comes_later_is_no_option_yet(self):
        self.refused(2, "render", "--sum", "forest", says=("--sum forest", "pattern, tree, all"))
        self.refused(2, "render", "--tolerance", "0.1", "--sum", "all", "--transport", "dipole",
                     says=("--tolerance", "--sum tree", "--transport boundary"))
        self.refused(2, "render", "--max-surfels", "4096", "--method", "paper", says="--max-surfels")
        self.refused(2, "render", "--dsm-size", "128", says=("--dsm-size", "--sum pattern"))
        self.refused(2, "render", "--max-surfels", "12", says=("--max-surfels", "1024"))
        self.refused(2, "render", "--tolerance", "0", says=("--tolerance", "0.0001"))

    def test_ambient_occlusion_where_it_would_do_nothing(self):
        self.refused(2, "render", "--ambient-occlusion", says=("--ambient-occlusion", "boundary"))
        for wrong in (("--integral",), ("--integral", "--aov", "exitance"), ("--path", "--aov", "irradiance")):
            self.refused(2, "reference", *wrong, "--ambient-occlusion", "--builtin", "bear",
                         says=("--ambient-occlusion", "--aov irradiance"))

    def test_what_only_the_body_itself_has_a_use_for(self):
        for option in (("--bounces", "1"), ("--max-clusters", "4096")):
            for other in (("--transport", "dipole"), ("--transport", "better-dipole"), ("--sum", "pattern"),
                          ("--method", "paper")):
                self.refused(2, "render", *option, *other, says=(option[0], "--transport boundary"))
        self.refused(2, "render", "--transport", "boundary", "--sum", "pattern",
                     says=("--transport boundary", "--sum tree"))
        self.refused(2, "render", "--transport", "slab", says=("--transport slab", "dipole, better-dipole, boundary"))
        self.refused(2, "reference", "--integral", "--transport", "boundary",
                     says=("--transport boundary", "better-dipole"))

    def test_no_argument_too_many(self):
        self.refused(2, "media", "marble", says="media takes no argument marble")

    def test_an_option_without_its_value_or_twice(self):
        self.refused(2, "render", "--size", says=("--size needs a value", "WxH"))
        self.refused(2, "render", "-o", says="needs a value")
        self.refused(2, "render", "--size", "8x8", "--size", "9x9", says=("--size", "8x8", "9x9"))
        self.refused(2, "media", "--json=maybe", says="--json")

    def test_values_out_of_range_name_option_reason_and_range(self):
        for option, text, says in [
            ("--size", "0x10", "from 1 to 16384"),
            ("--size", "16385x10", "from 1 to 16384"),
            ("--size", "10", "WIDTHxHEIGHT"),
            ("--size", "10x10x10", "WIDTHxHEIGHT"),
            ("--size", "-5x10", "WIDTHxHEIGHT"),
            ("--size", "99999999999999999999x1", "WIDTHxHEIGHT"),
            ("--eta", "1", "from 1.01 to 3"),
            ("--ground", "0.5,2,0", "from 0 to 1"),
            ("--ground", "0.5,0.5", "three numbers or one"),
            ("--eta", "nan", "must be from 1.01 to 3"),
            ("--eta", "1.3x", "'1.3x' is not a number"),
            ("--sigma-s", "1,2", "three numbers"),
            ("--sigma-s", "1,2,3,4", "three numbers"),
            ("--sigma-s", "1,2,inf", "each above 0 and at most 1e6 per mm"),
            ("--sigma-a", "-1,0,0", "each from 0 to 1e6 per mm"),
            ("--sigma-a", "1,,0", "three numbers"),
            ("--diagonal-mm", "0", "from 1e-6 to"),
            ("--diagonal-mm", "-3", "mm"),
            ("--diagonal-mm", "1e999", "is not a number"),
            ("--fov-degrees", "0", "from 1 to 170 degrees"),
            ("--fov-degrees", "171", "from 1 to 170 degrees"),
            ("--roughness", "0", "from 0.05 to 1"),
            ("--exposure", "33", "from -32 to 32 stops"),
            ("--antialias", "3", "1, 2, 4 or 8"),
            ("--tone", "filmic", "none, neutral"),
            ("--background", "2,0,0", "from 0 to 1"),
            ("--directional", "0,0,0", "must not be zero"),
            ("--directional", "0,0,1:1,1", "three numbers"),
            ("--directional", "0,0,nan", "must be from"),
            ("--directional", "0,0,1:-1,1,1", "each from 0"),
            ("--directional", "0,0,1:1:20", "--directional 0,0,1:1:20: '20': must be from 0 to 10"),
            ("--environment", "", "--environment needs a value, FILE"),
            ("--point", "0,0,10", "needs an intensity"),
            ("--rectangle", "0,0,10:1,0,0:0,1,0", "needs a centre, two half edges and a radiance"),
            ("--rectangle", "0,0,10:1,0,0:2,0,0:1", "neither be zero nor parallel"),
            ("--disc", "0,0,10:0,0,0:1:1", "must not be zero"),
            ("--disc", "0,0,10:0,0,-1:-1:1", "above 0 and at most 1e6 mm"),
            ("--sphere", "0,0,10:0:1", "above 0 and at most 1e6 mm"),
            ("--sphere", "0,0,nan:1:1", "must be from"),
            ("--tube", "0,0,10:0,0,10:1:1", "two places"),
            ("--tube", "0,0,10:0,0,20:1:-1", "each from 0"),
            ("--spot", "0,0,10:1", "needs a place, an intensity and a direction"),
            ("--spot", "0,0,10:1:0,0,-1:30", "needs two angles"),
            ("--spot", "0,0,10:1:0,0,0", "must not be zero"),
            ("--spot", "0,0,10:1:0,0,-1:30,20", "must not be above outer_degrees"),
            ("--spot", "0,0,10:1:0,0,-1:30,91", "0,0,10:1:0,0,-1:30,91: '91': must be above 0 and at most 90"),
            ("--spot", "0,0,10:-1:0,0,-1", "each from 0"),
            ("--ambient", "-1,0,0", "each from 0"),
            ("--camera-direction", "0,0,0", "must not be zero"),
            ("--bounces", "9", "from 0 to 8"),
            ("--bounces", "-1", "from 0 to 8"),
            ("--bounces", "1.5", "whole number"),
            ("--max-clusters", "63", "from 64 to 262144"),
            ("--max-clusters", "262145", "from 64 to 262144"),
            ("--near-rings", "16", "from 0 to 15"),
            ("--near-rings", "1.5", "whole number"),
            ("--near-spacing", "0", "from 0.001 to 100"),
            ("--far-distance", "1001", "from 0.001 to 1000"),
            ("--far-distance", "nan", "from 0.001 to 1000"),
            ("--near-spacing", "", "needs a value"),
            ("--device", "", "needs a value"),
            ("--ray-queries", "maybe", "auto, on, off"),
            ("--dsm-size", "63", "from 64 to 4096"),
            ("--shadow-size", "8193", "from 64 to 8192"),
            ("--aov", "depht", "did you mean depth?"),
            ("--aov", "surfel", "did you mean surfels?"),
            ("--aov", "surfels:65", "from 0 to 64"),
            ("--aov", "surfels:", "whole number"),
            ("--site", "edge", "auto, vertex, fragment"),
            ("--method", "ours", "must be paper"),
            ("--medium", "marbel", "did you mean marble?"),
            ("--builtin", "bunny", "bear, teapot"),
            ("--color-model", "bogus", "observed, khr"),
            ("-o", "a.jpg", "must end in .png, .exr or .mp4"),
            ("-o", "png", "must end in .png, .exr or .mp4"),
            ("--report", "a.txt", ".json"),
            ("--time", "-1", "from 0 to"),
            ("--time", "nan", "must be from 0"),
            ("--time", "soon", "not a number"),
            ("--fps", "0", "from 1 to 1000"),
            ("--fps", "1001", "from 1 to 1000"),
            ("--frames", "3", "FIRST:LAST"),
            ("--frames", "0:1:2:3", "FIRST:LAST"),
            ("--frames", "0:10:0", "--frames 0:10:0: '0': must be a whole number from 1"),
            ("--ambient", "1,2", "or one for all three"),
            ("--environment-rotation", "north", "not a number"),
            ("--environment-intensity", "-1", "from 0 to"),
            ("--frames", "-1:2", "whole number from 0"),
            ("--frames", "0:1.5", "whole number from 0"),
            ("--frames", "0:99999999999999999999", "whole number from 0"),
            ("--frames", ":", "whole number from 0"),
            ("--frames", "5:4", "before the first"),
            ("--deform", "twisd:1", "did you mean twist?"),
            ("--deform", "twist", "KIND:AMOUNT"),
            ("--deform", "twist:1:2:3", "KIND:AMOUNT"),
            ("--deform", "twist:", "'' is not a number"),
            ("--deform", "twist:101", "from -100 to 100 radians"),
            ("--deform", "bend:6.3", "from -6.28 to 6.28 radians"),
            ("--deform", "squash:1", "from -3 to 0.9"),
            ("--deform", "squash:-1:2", "from -0.9 to 0.9"),
            ("--deform", "wobble:-1.1", "from -1 to 1"),
            ("--deform", "wobble:nan", "must be from"),
            ("--deform", "wobble:0.1:-1", "must be from 0"),
        ]:
            with self.subTest(option=option, text=text):
                self.refused(2, "render", f"{option}={text}" if option != "-o" else f"-o{text}",
                             says=says)
        for option, text in [("--samples", "1"), ("--max-radius-mm", "0"), ("--plot", "a.png")]:
            self.refused(2, "profile", option, text, says=(f"{option} {text}",))
        self.assertEqual(self.listing(), [])

    def test_a_word_for_numbers_is_no_scene(self):
        for colour in ("nan", "inf", "0.5,nan,0", "0.5,0.5", "2"):
            self.refused(2, "render", "--ground", colour, says=(f"--ground {colour}", "from 0 to 1"))
        self.refused(1, "render", "--ground", "nan.ply", says="Cannot read nan.ply")
        self.write("nan", "")
        self.refused(1, "render", "--ground", "nan", says="nan")

    def test_mixtures_that_make_no_sense(self):
        for arguments, says in [
            (("--sigma-s", "1,1,1"), "--sigma-a"),
            (("--sigma-a", "1,1,1"), "--sigma-s"),
            (("--eta", "1.4"), "--sigma-s"),
            (("--g", "0.9"), "--medium"),
            (("--medium", "skin1", "--sigma-s", "1,1,1", "--sigma-a", "1,1,1"), "exclude each other"),
            (("--medium", "wax", "--medium", "marble"), ("--medium marble", "twice")),
            (("--medium", "marble@ball", "--medium", "wax@ball"), ("--medium wax@ball", "twice")),
            (("--sigma-s", "0,1,1", "--sigma-a", "0,1,1"), "each above 0"),
            (("--sigma-s", "0,1,1", "--sigma-a", "1,1,1"), "each above 0"),
            (("--builtin", "bear", "a.ply"), "exclude each other"),
            (("--aov", "normal", "-o", "a.png"), ".exr"),
            (("--aov", "normal", "--antialias", "4"), "--antialias"),
            (("--aov", "surfels", "--sum", "pattern"), "--sum tree"),
            (("--aov", "surfels:3", "--method", "paper"), "--sum tree"),
            (("-o", "a.exr", "--exposure", "1"), "linear"),
            (("--no-specular", "--roughness", ".3"), "--roughness"),
            (("--method", "paper", "--transport", "better-dipole"), "contradicts --method paper"),
            (("--method", "paper", "--transport", "boundary"), "contradicts --method paper"),
            (("--method", "paper", "--sum", "all"), "contradicts --method paper"),
            (("--method", "paper", "--site", "vertex"), "contradicts --method paper"),
            (("--sum", "all", "--near-rings", "3"), "--sum pattern"),
            (("--time", "1", "--frames", "0:1"), ("--time", "--frames")),
            (("--fps", "25"), "--frames"),
            (("--resume",), "--frames"),
            (("-o", "a.mp4"), ("a.mp4", "--frames")),
            (("-o", "a_%04d.png"), ("a_%04d.png", "--frames")),
            (("--frames", "0:1", "-o", "a.png"), ("a.png", "%04d", ".mp4")),
            (("--frames", "0:1", "-o", "a_%d_%d.png"), "one %d or %04d"),
            (("--frames", "0:1", "-o", "a_%4d.png"), "one %d or %04d"),
            (("--frames", "0:1", "-o", "a_%s.png"), "one %d or %04d"),
            (("--frames", "0:1", "-o", "a.mp4", "--resume"), "one go"),
            (("--frames", "0:1", "-o", "a.mp4", "--aov", "depth"), ".exr"),
            (("--morph-to", "a.ply"), "--morph-to a.ply"),
            (("--clip", "walk", "--size", "8x8"), "no clips"),
        ]:
            with self.subTest(arguments=arguments):
                self.refused(2, "render", *arguments, says=says)
        self.assertEqual(self.listing(), [])


class Bench(ProgramTest):
    def test_suites(self):
        self.refused(2, "bench", says=("suite", "table1"))
        self.refused(2, "bench", "tabel1", says=("tabel1", "table1"))
        self.refused(2, "bench", "table1", "--frames", "0", says="from 1 to 1000")


if __name__ == "__main__":
    unittest.main()
