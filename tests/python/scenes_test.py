"""Scenes, media, lights and cameras say what they are, and refuse what cannot be rendered."""

import logging
import pathlib
import tempfile
import unittest

import numpy as np
from bodies import CORNERS, FACES, scene, shared_renderer, small

import opaline


class Media(unittest.TestCase):
    def test_measured_ones_are_those_of_the_paper(self):
        media = opaline.media()
        self.assertEqual(len(media), 18)
        np.testing.assert_array_equal(media["marble"].sigma_a_per_mm, (.0021, .0041, .0071))  # Jensen et al. 2001, Figure 5
        np.testing.assert_array_equal(media["skin1"].sigma_s_prime_per_mm, (.74, .88, 1.01))

    def test_names_and_numbers(self):
        self.assertEqual(opaline.Medium("Jade"), opaline.media()["jade"])
        own = opaline.Medium(sigma_s_prime_per_mm=(1, 2, 3), sigma_a_per_mm=np.float32([.5, .25, .125]), eta=1.4)
        np.testing.assert_array_equal(own.sigma_a_per_mm, (.5, .25, .125))
        self.assertEqual(own.eta, 1.4)
        with self.assertRaises(ValueError):
            own.sigma_a_per_mm[0] = 1  # would change a copy

    def test_what_is_refused(self):
        for wrong in (lambda: opaline.Medium("granite"), lambda: opaline.Medium(),
                      lambda: opaline.Medium(sigma_s_prime_per_mm=(1, 1), sigma_a_per_mm=(1, 1, 1)),
                      lambda: opaline.Medium(sigma_s_prime_per_mm=(0, 1, 1), sigma_a_per_mm=(1, 1, 1)),
                      lambda: opaline.Medium("wax", eta=float("nan"))):
            with self.assertRaises(opaline.UsageError):
                wrong()
        with self.assertRaisesRegex(opaline.UsageError, "^sigma_s_prime_per_mm"):
            opaline.Medium(sigma_s_prime_per_mm=(-1, 1, 1), sigma_a_per_mm=(1, 1, 1))

    def test_appearance(self):
        pale = opaline.Medium.from_appearance((.9, .9, .9), (1, 1, 1))
        dark = opaline.Medium.from_appearance((.2, .2, .2), (1, 1, 1))
        self.assertTrue((pale.sigma_a_per_mm < dark.sigma_a_per_mm).all())


class Scenes(unittest.TestCase):
    def test_lights(self):
        made = scene()
        self.assertEqual(len(made.lights), 2)
        made.lights = [opaline.SphereLight((0, 30, 0), 5), opaline.DirectionalLight((0, 0, 2), irradiance=(1, 2, 3))]
        self.assertEqual([type(light).__name__ for light in made.lights], ["DirectionalLight", "SphereLight"])
        self.assertEqual(made.lights[0].direction_to_light, (0, 0, 1))
        self.assertEqual(made.lights[0].irradiance, (1, 2, 3))
        with self.assertRaises(AttributeError):
            made.lights[0].irradiance = (1, 1, 1)
        with self.assertRaises(opaline.UsageError):
            made.lights = [opaline.DirectionalLight((0, 0, 1))] * 17
        with self.assertRaises(TypeError):
            made.lights = [3]
        for wrong in (lambda: opaline.Medium(5), lambda: opaline.Medium("wax", eta="x"), lambda: opaline.bear(5)):
            with self.assertRaises(TypeError):
                wrong()
        with self.assertRaises(opaline.UsageError):
            opaline.DirectionalLight((0, 0, 0))
        self.assertEqual(len(made.lights), 2)

    def test_light_is_linear(self):
        made = scene()
        made.lights, made.ambient = [opaline.DirectionalLight((0.2, 0.3, 1), irradiance=(1, 2, 4))], (0, 0, 0)
        once = small(shared_renderer(made), "exitance")["exitance"]
        made.lights = [opaline.DirectionalLight((0.2, 0.3, 1), irradiance=(2, 4, 8))]
        np.testing.assert_allclose(small(shared_renderer(made), "exitance")["exitance"][..., :3], 2 * once[..., :3], rtol=1e-5)
        self.assertGreater(once[..., :3].max(), 0.01)

    def test_an_environment_of_one_colour_is_ambient_light(self):
        made = scene()
        made.lights, made.ambient = [], (.5, .25, 1)
        expected = small(shared_renderer(made), "exitance")["exitance"]
        made.ambient = (0, 0, 0)
        made.set_environment(np.broadcast_to(np.float32([.5, .25, 1]), (16, 32, 3)))
        np.testing.assert_allclose(small(shared_renderer(made), "exitance")["exitance"], expected, rtol=.01, atol=1e-4)

    def test_objects_are_shared(self):
        made = scene()
        made.objects[0].medium = "wax"
        self.assertEqual(made.objects[0].medium, opaline.Medium("wax"))
        made.add_ground()
        self.assertTrue(made.objects[1].is_opaque)
        self.assertAlmostEqual(float(made.objects[1].positions_mm[:, 1].max()), -10, places=4)
        self.assertAlmostEqual(made.diagonal_mm, 20 * 3**.5, places=3)

    def test_the_camera(self):
        made = scene()
        made.camera = opaline.Camera(position_mm=(0, 0, 120), target_mm=(0, 0, 0), vertical_fov_degrees=30)
        depth = opaline.Renderer(made).render(25, 17, "depth", transport="dipole")["depth"]
        self.assertAlmostEqual(float(depth[8, 12, 0]), 110, delta=.01)
        for wrong in ({"position_mm": (0, 0, 0)}, {"position_mm": (0, 0, 1), "vertical_fov_degrees": 200}):
            with self.assertRaises(opaline.UsageError):
                opaline.Camera(**wrong)

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "body.obj")
            file.write_text("".join("v %g %g %g\n" % tuple(corner) for corner in CORNERS)
                            + "".join("f %d %d %d\n" % tuple(face + 1) for face in FACES))
            with self.assertLogs("opaline", logging.INFO):
                opaline.load(file)  # it has no unit
            made = opaline.load(str(file), medium="jade", diagonal_mm=50)
            self.assertAlmostEqual(made.diagonal_mm, 50, places=3)
            self.assertEqual(made.objects[0].medium, opaline.Medium("jade"))
            self.assertRegex(repr(made), ": 1 object>$")
            with self.assertRaisesRegex(opaline.Error, "nothing.ply"):
                opaline.load(pathlib.Path(folder, "nothing.ply"))


if __name__ == "__main__":
    unittest.main()
