"""Materials, pictures on them, normals and paint."""

import unittest

import numpy as np
from bodies import shared_renderer

import opaline

SQUARE = np.array([(-10, -10, 0), (10, -10, 0), (10, 10, 0), (-10, 10, 0)], dtype=float)
HALVES = np.array([(0, 1, 2), (0, 2, 3)])
PLACES = np.array([(0, 1), (1, 1), (1, 0), (0, 0)], dtype=float)


def picture_of(body, width=16, height=16, specular=False):
    made = opaline.Scene([body])
    made.lights = [opaline.DirectionalLight((0, 0, 1), irradiance=(1, 1, 1))]
    made.ambient = (0, 0, 0)
    made.camera = opaline.Camera((0, 0, 100), orthographic_height_mm=20)
    return shared_renderer(made).render(width, height, transport="dipole", max_surfels=4096, antialias=1, specular=specular)["radiance"]


class Materials(unittest.TestCase):
    def test_a_texture_lies_where_its_coordinates_say(self):
        # Red and green above, blue and white below.
        pixels = np.array([[(255, 0, 0), (0, 255, 0)], [(0, 0, 255), (255, 255, 255)]], dtype=np.uint8)
        texture = opaline.Texture(pixels, interpolated=False)
        self.assertEqual(texture.size, (2, 2))
        material = opaline.OpaqueMaterial(base_color=(1, 1, 1), base_color_texture=texture, specular=0)
        found = picture_of(opaline.Object(SQUARE, HALVES, material=material, texture_coordinates=PLACES))
        # A white matt surface under an irradiance of 1 has a radiance of 1/pi.
        for (row, column), color in (((4, 4), (1, 0, 0)), ((4, 12), (0, 1, 0)), ((12, 4), (0, 0, 1)), ((12, 12), (1, 1, 1))):
            np.testing.assert_allclose(found[row, column, :3] * np.pi, color, atol=2e-3)

    def test_emission(self):
        glow = opaline.OpaqueMaterial(base_color=(0, 0, 0), specular=0, emission=(1, 2, 3))
        found = picture_of(opaline.Object(SQUARE, HALVES, material=glow))
        np.testing.assert_allclose(found[8, 8, :3], (1, 2, 3), rtol=1e-3)

    def test_light_goes_through_a_leaf(self):
        leaf = opaline.OpaqueMaterial(base_color=(1, 1, 1), specular=0, diffuse_transmission=0.5,
                                      diffuse_transmission_color=(0.5, 1, 0))
        self.assertEqual(leaf.diffuse_transmission, 0.5)
        for triangles in (HALVES, HALVES[:, ::-1]):
            lit = picture_of(opaline.Object(SQUARE, triangles, material=leaf))
            np.testing.assert_allclose(lit[8, 8, :3] * np.pi, 0.5, atol=1e-3)
        body = opaline.Object(SQUARE * (1, 1, -1), HALVES, material=leaf)
        made = opaline.Scene([body])
        made.lights = [opaline.DirectionalLight((0, 0, -1), irradiance=(1, 1, 1))]
        made.ambient = (0, 0, 0)
        made.camera = opaline.Camera((0, 0, 100), orthographic_height_mm=20)
        behind = shared_renderer(made).render(16, 16, max_surfels=4096, antialias=1, specular=False)["radiance"]
        np.testing.assert_allclose(behind[8, 8, :3] * np.pi, (0.25, 0.5, 0), atol=1e-3)

    def test_normals_are_those_given(self):
        # Turned by 60 degrees from the light: half as bright.
        tilted = np.tile((np.sin(np.pi / 3), 0, 0.5), (4, 1)) * 7
        matt = opaline.OpaqueMaterial(base_color=(1, 1, 1), specular=0)
        found = picture_of(opaline.Object(SQUARE, HALVES, material=matt, normals=tilted))
        np.testing.assert_allclose(found[8, 8, :3] * np.pi, 0.5, atol=5e-3)

    def test_paint_darkens(self):
        def mean(paint):
            body = opaline.Object(SQUARE, HALVES, medium="marble", paint=paint)
            return picture_of(body)[4:12, 4:12, :3].mean(axis=(0, 1))
        plain, painted = mean(None), mean(opaline.Paint((0.1, 0.8, 0.1)))
        self.assertLess(painted[0], 0.4 * plain[0])
        self.assertLess(painted[0], 0.5 * painted[1])

    def test_a_translucent_surface_is_as_rough_as_it_says(self):
        scene = opaline.bear("jade")
        scene.camera = opaline.Camera((0, 0, 110))
        scene.lights = [opaline.RectangleLight((40, 40, 60), (-4, 14, -6), (12, 0, -8), radiance=(9, 9, 9))]
        renderer = shared_renderer(scene)

        def picture(**options):
            return renderer.render(48, 48, transport="dipole", max_surfels=8192, **options)["radiance"][..., :3]
        smooth, rough = (picture(roughness=value) for value in (0.1, 0.6))
        self.assertGreater(smooth.max(), 1.5 * rough.max())
        # The body's own roughness goes before the picture's. Its lobes are interpolated between a few roughnesses.
        renderer.set_material(0, "jade", surface=opaline.TranslucentSurface(roughness=0.1))
        own = picture(roughness=0.6)
        self.assertLess(np.square(own - smooth).mean(), 1e-2 * np.square(rough - smooth).mean())
        # A texture multiplies it: green is half of 1.
        grey = opaline.Texture(np.full((2, 2, 3), 0.5, dtype=np.float32))
        textured = opaline.Object(SQUARE, HALVES, medium="jade", texture_coordinates=PLACES,
                                  surface=opaline.TranslucentSurface(roughness=0.8, metallic_roughness_texture=grey))
        plain = opaline.Object(SQUARE, HALVES, medium="jade", surface=opaline.TranslucentSurface(roughness=0.4))
        for body in (textured, plain):
            self.assertFalse(body.is_opaque)
        shiny = [picture_of(body, specular=True) for body in (textured, plain)]
        np.testing.assert_allclose(*shiny, rtol=1e-3, atol=1e-5)

    def test_materials_are_changed_in_place(self):
        made = opaline.Scene([opaline.Object(SQUARE, HALVES, opaque_color=(1, 1, 1))])
        made.lights = [opaline.DirectionalLight((0, 0, 1), irradiance=(1, 1, 1))]
        made.ambient = (0, 0, 0)
        made.camera = opaline.Camera((0, 0, 100), orthographic_height_mm=20)
        renderer = shared_renderer(made)
        renderer.set_material(0, opaque_color=(0.2, 0.4, 0.6))
        found = renderer.render(8, 8, transport="dipole", max_surfels=4096)["radiance"]
        np.testing.assert_allclose(found[4, 4, :3] * np.pi, (0.2, 0.4, 0.6), atol=2e-3)
        with self.assertRaises(opaline.UsageError):
            renderer.set_material(0, "jade")

    def test_refusals(self):
        cases = (lambda: opaline.Texture(np.zeros((2, 2, 2))), lambda: opaline.Texture(np.zeros((2, 2, 3)), wrap="spiral"),
                 lambda: opaline.Texture(np.full((2, 2, 3), np.nan)), lambda: opaline.Texture(np.zeros((2, 2, 3), dtype=int)),
                 lambda: opaline.OpaqueMaterial(roughness=2), lambda: opaline.OpaqueMaterial(ior=0.5),
                 lambda: opaline.Paint((-1, 0, 0)), lambda: opaline.Object(SQUARE, HALVES, normals=SQUARE[:3]),
                 lambda: opaline.Object(SQUARE, HALVES, texture_coordinates=PLACES[:3]),
                 lambda: opaline.Object(SQUARE, HALVES, texture_coordinates=SQUARE),
                 lambda: opaline.Object(SQUARE, HALVES, opaque_color=(1, 1, 1), paint=opaline.Paint()),
                 lambda: opaline.TranslucentSurface(roughness=1.5),
                 lambda: opaline.Object(SQUARE, HALVES, opaque_color=(1, 1, 1), surface=opaline.TranslucentSurface()))
        for case in cases:
            with self.assertRaises(opaline.UsageError):
                case()


if __name__ == "__main__":
    unittest.main()
