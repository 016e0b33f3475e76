"""Every key that the program prints is in docs/json.md, and the other way round; those of bench are tested in
bench_test.py."""

import json
import re
import unittest

from json_keys import MEDIUM, documented, keys, without_medium
from program import CUBE_OBJ, ProgramTest

TETRAHEDRON = ("ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
               "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0\n3 0 2 1\n3 0 4 3\n3 0 3 2\n3 1 2 3\n")
SCENE = ("t.ply", "--diagonal-mm", 10, "--medium", "marble", "--ambient", "1,1,1")


class Keys(ProgramTest):
    maxDiff = None

    def setUp(self):
        super().setUp()
        self.write("t.ply", TETRAHEDRON)

    def printed(self, *arguments):
        return self.succeed(*arguments, "--json").json()

    def expect(self, section, found):
        self.assertEqual(found, documented(section))

    def test_render_and_view(self):
        still = self.printed("render", *SCENE, "--size", "8x8", "--report", "report.json")
        self.assertEqual(json.loads((self.folder / "report.json").read_text()), still)
        film = self.printed("render", *SCENE, "--size", "8x8", "--frames", "0:1", "-o", "f%d.png", "--quiet")
        self.assertEqual(keys(film) - keys(still), {"frames", "frame_step", "fps"})
        self.expect("render", keys(film) | keys(still))
        self.expect("film", keys({**self.printed("film", ".", "--check"), "outputs": ["a.mp4"]}))

    def test_reference(self):
        view = (*SCENE, "--size", "8x8", "--aov", "exitance", "-o", "a.exr")
        integral = keys(self.printed("reference", "--integral", *view, "--tolerance", 0.1))
        path = keys(self.printed("reference", "--path", "--samples", 1000, *SCENE, "--size", "8x8", "-o", "b.exr"))
        film = keys(self.printed("reference", "--integral", *view[:-1], "a%d.exr", "--frames", "0:0", "--every", 4))
        of_pictures = {key.removeprefix("pictures[].") for key in film if key.startswith("pictures[].")}
        self.assertEqual(of_pictures - integral, {"frame"})
        film = {key for key in film if not key.startswith("pictures[].")} | {"pictures[].frame"}
        self.assertEqual(film - integral, {"frames", "frame_step", "fps", "pictures[].frame"})
        self.expect("reference", integral | path | film)

    def test_compare(self):
        self.succeed("render", *SCENE, "--size", "16x16", "-o", "a.exr")
        found = keys(self.printed("compare", "a.exr", "a.exr", "--mask", "a.exr", "--block", 8, "--heatmap", "h.png"))
        found = {key for key in found if not re.search(r"channels\.[gb]\.", key)}
        whole = {key for key in found if not key.startswith("regions.")}
        regions = {re.sub(r"^regions\.(in|out)side\.", "", key) for key in found - whole} - {"regions.inside", "regions.outside"}
        self.assertEqual(regions, whole - {"a", "b", "size", "values", "heatmap.file", "heatmap.top"})
        self.expect("compare", whole | {"regions.inside", "regions.outside"})

    def test_info(self):
        # A clip by turning into another mesh; a vertex that no triangle has is mended.
        self.write("u.ply", TETRAHEDRON.replace("0 0 1\n", "0 0 2\n"))
        found = keys(self.printed("info", "t.ply", "--morph-to", "u.ply", "--atlas", "a.png"))
        # And what is named in a file.
        self.write("named.obj", "o pot\nusemtl glaze\n" + CUBE_OBJ)
        found |= keys(self.printed("info", "named.obj"))
        # And materials with textures.
        self.succeed("render", *SCENE, "--size", "8x8", "-o", "grey.png")
        self.write("painted.toml", 'model = "named.obj"\n[materials.paint]\nkind = "opaque"\n'
                   'base_color_texture = "grey.png"\n[objects.named]\nmaterial = "paint"\n')
        found |= keys(self.printed("info", "painted.toml"))
        self.write("s_1.obj", CUBE_OBJ)
        found = found - {"sequence"} | keys(self.printed("info", "s_%d.obj"))
        self.expect("info", without_medium(found, "objects[].medium"))

    def test_media_and_profile(self):
        media = keys(self.printed("media"))
        self.expect("media", media)
        of_a_medium = {f"media[].{key}" for key in MEDIUM}
        self.assertEqual(media & of_a_medium, of_a_medium)
        found = keys(self.printed("profile", "--samples", 2))
        self.expect("profile", without_medium(found, "medium"))


if __name__ == "__main__":
    unittest.main()
