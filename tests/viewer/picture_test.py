"""What the window shows is what `render` draws."""

import base64
import json
import struct
import unittest

from driver import BACKGROUND, COARSE, CORNERS, Shot, WindowTest
from images import read_png, write_png
from program import CUBE_OBJ


def moving_light_and_camera():
    """A glTF file of a tetrahedron, whose only clip moves a point light and the camera, in metres."""
    rows = ((0, 0, 0, .1, 0, 0, 0, .1, 0, 0, 0, .1), (0, 2), (-.2, .1, .3, .4, .1, .3), (0, 0, .4, 0, .1, .5))
    faces = struct.pack("<12H", 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3)
    data = b"".join(struct.pack(f"<{len(row)}f", *row) for row in rows) + faces
    sizes = [4 * len(row) for row in rows] + [len(faces)]
    views = [{"buffer": 0, "byteOffset": sum(sizes[:i]), "byteLength": size} for i, size in enumerate(sizes)]
    kinds = ((5126, 4, "VEC3"), (5126, 2, "SCALAR"), (5126, 2, "VEC3"), (5126, 2, "VEC3"), (5123, 12, "SCALAR"))
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": .5}]}},
        "nodes": [{"mesh": 0}, {"extensions": {"KHR_lights_punctual": {"light": 0}}}, {"camera": 0}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": .6, "znear": .01}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 4}]}],
        "animations": [{"samplers": [{"input": 1, "output": 2}, {"input": 1, "output": 3}],
                        "channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}},
                                     {"sampler": 1, "target": {"node": 2, "path": "translation"}}]}],
        "accessors": [{"bufferView": i, "componentType": kind, "count": count, "type": name}
                      for i, (kind, count, name) in enumerate(kinds)],
        "bufferViews": views,
        "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]})


class Picture(WindowTest):
    def setUp(self):
        super().setUp()
        self.write("cube.obj", CUBE_OBJ)

    def same(self, shown, rendered):
        """Two roundings of one value: at most a step apart."""
        self.assertLessEqual(shown.worst(rendered), 1)
        self.assertGreater(shown.colors(), 100, "there is something to see")

    def check(self, *arguments):
        # Wide enough for all of the body: else the window frames it, and render does not.
        window = self.view(*arguments, "--size", "760x240")
        window.key("h")
        self.same(window.picture(), self.rendered(window, *arguments, *BACKGROUND))
        return window

    def test_the_default_method(self):
        self.check("--builtin", "teapot", "--medium", "skin1").close()

    def test_the_paper(self):
        self.check("cube.obj", "--method", "paper", "--medium", "marble", "--dsm-size", "128", "--shadow-size", "256", "--point", "20,30,20:900,900,800",
                   "--ambient", ".3,.2,.1").close()

    def test_tone_and_no_reflection(self):
        self.check("cube.obj", "--transport", "better-dipole", "--site", "vertex", *COARSE, "--exposure", "1.5", "--tone", "none",
                   "--no-specular", "--antialias", "8").close()

    def test_motion_and_camera(self):
        self.check("cube.obj", "--transport", "dipole", *COARSE, "--deform", "twist:0.6", "--time", "1.25", "--camera-direction", "1,.5,2",
                   "--fov-degrees", "40").close()

    def test_a_saved_picture_is_the_same(self):
        window = self.view("cube.obj", *CORNERS, "--size", "640x400")
        window.key("h")
        window.drag((100, 100), (180, 60))
        shown = window.picture()
        window.only("Save")
        window.save_as("picture")
        window.wait_for(lambda: window.state()["message"] == "saved cube.png", "not saved")
        (self.folder / "cube.png").unlink()
        window.key("p")
        self.assertEqual(window.state()["message"], "saved cube.png")
        self.same(shown, Shot.of(read_png((self.folder / "cube.png").read_bytes())))
        window.close()

    def test_a_saved_scene_is_drawn_the_same(self):
        """Camera, medium, light, size, motion, method and look as they were left by hand."""
        window = self.view("cube.obj", *CORNERS, "--size", "760x700")
        window.drag((100, 100), (180, 60))
        window.click("Medium/gummy-orange")
        size = window.place("Medium/size")
        window.drag((size[0] - 30, size[1]), (size[0] - 40, size[1]))
        window.only("Light")
        window.click("Light/directional 1")
        turn = window.place("Light/turn")
        window.drag(turn, (turn[0] + 30, turn[1]))
        window.click("Light/add point")
        window.only("Motion")
        window.click("Motion/add a deformation")
        time = window.place("Motion/time")
        window.drag(time, (time[0] + 25, time[1]))
        window.only("Method")
        window.choose("Method/transport", "better-dipole")
        window.key("o")
        window.key("h")
        window.only("Save")
        window.save_as("scene")
        window.wait_for(lambda: window.state()["message"] == "saved cube.toml", "not saved")
        window.settle()
        # The message stands in the corner of the picture.
        shown = window.picture().part(top=40)
        self.same(shown, self.rendered(window, "cube.toml").part(top=40))
        window.close()
        again = self.view("cube.toml", "--size", "760x700")
        self.same(again.picture().part(top=40), shown)
        again.close()

    def test_a_saved_scene_whose_light_and_camera_move(self):
        self.write("moving.gltf", moving_light_and_camera())
        window = self.view("moving.gltf", "--medium", "wax", *CORNERS, "--time", .5, "--size", "760x400")
        window.key("h")
        window.key("s")
        window.wait_for(lambda: window.state()["message"] == "saved moving.toml", "no scene was saved")
        window.key("Escape")
        window.move((5, 5))
        window.settle()
        shown = window.picture()
        self.assertGreater(shown.colors(), 20)
        self.assertLessEqual(shown.worst(self.rendered(window, "moving.toml")), 1)
        # A light that was edited is as it was again, and so moves.
        window.only("Light")
        window.click("Light/point 1")
        window.click("Light/delete")
        window.key("ctrl+z")
        window.move((5, 5))
        window.settle()
        self.assertLess(shown.part(top=100).difference(window.picture().part(top=100)), .2)
        window.close()

    def test_an_edited_material_is_drawn_and_saved(self):
        """An opaque object with a texture: seen at once, undone, repeated, and drawn the same by `render`."""
        (self.folder / "tile.obj").write_text(
            "mtllib tile.mtl\nusemtl glaze\nvt .5 .5\n" + CUBE_OBJ.replace("//", "/1/"), encoding="utf-8")
        (self.folder / "tile.mtl").write_text("newmtl glaze\nKd .2 .5 .3\nmap_Kd tile.png\n", encoding="utf-8")
        (self.folder / "tile.png").write_bytes(write_png([[(200, 160, 120, 255)] * 4] * 4))
        window = self.view("tile.obj", *CORNERS, "--size", "700x620")
        window.key("h")
        window.only("Material")
        self.assertIn("Material/base color texture", window.state()["controls"])
        before = window.picture()
        roughness = window.place("Material/roughness")
        window.drag((roughness[0] + 40, roughness[1]), (roughness[0] - 50, roughness[1]))
        metallic = window.place("Material/metallic")
        window.drag((metallic[0] - 50, metallic[1]), (metallic[0] + 30, metallic[1]))
        edited = window.picture()
        self.assertGreater(before.difference(edited), .3)
        window.key("ctrl+z")
        window.key("ctrl+z")
        self.assertLessEqual(window.picture().part(top=40).worst(before.part(top=40)), 1)
        window.key("ctrl+shift+z")
        window.key("ctrl+shift+z")
        self.assertLessEqual(window.picture().part(top=40).worst(edited.part(top=40)), 1)
        window.only("Save")
        window.save_as("scene")
        window.wait_for(lambda: window.state()["message"] == "saved tile.toml", "not saved")
        self.assertLessEqual(edited.part(top=40).worst(self.rendered(window, "tile.toml").part(top=40)), 1)
        window.close()


if __name__ == "__main__":
    unittest.main()
