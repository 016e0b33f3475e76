"""Arrays of every kind that NumPy has become positions, and what makes no sense is refused with a sentence."""

import unittest
import warnings

import numpy as np
from bodies import CORNERS, FACES, octahedron, scene, small

import opaline


class Positions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.renderer = opaline.Renderer(scene())
        cls.moved = CORNERS * (1, 0.5, 1)
        cls.renderer.set_positions(0, cls.moved.astype(np.float32))
        cls.expected = small(cls.renderer)["position"]

    def assert_same(self, positions):
        self.renderer.restore_positions(0)
        self.renderer.set_positions(0, positions)
        np.testing.assert_array_equal(small(self.renderer)["position"], self.expected)

    def test_they_move_the_body(self):
        height = self.expected[..., 1][self.expected[..., 3] > 0]
        self.assertGreater(height.max(), 3)
        self.assertLessEqual(height.max(), 5.001)

    def test_numbers_of_any_kind(self):
        for kind in (np.float16, np.float32, np.float64, np.longdouble, np.int8, np.int64, ">f4", ">f8"):
            with self.subTest(kind=kind):
                self.assert_same(self.moved.astype(kind))

    def test_lists(self):
        self.assert_same(self.moved.tolist())

    def test_any_strides(self):
        wide = np.zeros((12, 7))
        wide[::2, 1:6:2] = self.moved
        for name, positions in {"every other": wide[::2, 1:6:2], "columns first": np.asfortranarray(self.moved),
                                "backwards": self.moved[::-1].copy()[::-1], "transposed": self.moved.T.copy().T}.items():
            with self.subTest(name):
                self.assert_same(positions)
        fields = np.zeros(6, dtype=[("position", np.float32, 3), ("weight", np.float32)])
        fields["position"] = self.moved
        self.assert_same(fields["position"])

    def test_read_only(self):
        fixed = self.moved.copy()
        fixed.flags.writeable = False
        self.assert_same(fixed)

    def test_they_are_copied(self):
        positions = self.moved.copy()
        self.renderer.set_positions(0, positions)
        positions[:] = 0
        np.testing.assert_array_equal(small(self.renderer)["position"], self.expected)

    def test_what_is_refused(self):
        broken = self.moved.copy()
        broken[3, 1] = np.nan
        endless = self.moved.copy()
        endless[3, 1] = 1e300
        for name, positions in {"rows": self.moved[:5], "columns": self.moved[:, :2], "flat": self.moved.ravel(),
                                "three axes": self.moved[None], "none": np.zeros((0, 3)), "NaN": broken, "too far": endless,
                                "text": [("a", "b", "c")] * 6, "complex": self.moved.astype(complex),
                                "truths": self.moved > 0}.items():
            with self.subTest(name), warnings.catch_warnings(), self.assertRaises(opaline.UsageError) as caught:
                warnings.simplefilter("ignore", RuntimeWarning)  # NumPy's, of numbers beyond a float
                self.renderer.set_positions(0, positions)
            self.assertGreater(len(str(caught.exception)), 10)
        with self.assertRaises(opaline.UsageError):
            self.renderer.set_positions(1, self.moved)
        self.renderer.set_positions(0, self.moved)
        np.testing.assert_array_equal(small(self.renderer)["position"], self.expected)

    def test_the_message_names_the_shape(self):
        with self.assertRaisesRegex(opaline.UsageError, r"\(6, 2\)"):
            self.renderer.set_positions(0, self.moved[:, :2])


class Bodies(unittest.TestCase):
    def test_arrays_come_back(self):
        body = octahedron()
        np.testing.assert_array_equal(body.positions_mm, CORNERS)
        np.testing.assert_array_equal(body.triangles, FACES)
        self.assertEqual((body.positions_mm.dtype, body.triangles.dtype), (np.float32, np.uint32))
        # Smooth normals of a regular octahedron point away from its middle.
        np.testing.assert_allclose(body.normals, CORNERS / 10, atol=1e-6)

    def test_any_mesh_that_has_vertices_and_faces(self):
        class Mesh:
            vertices, faces = CORNERS, FACES.astype(np.uint8)

        np.testing.assert_array_equal(opaline.Object(Mesh(), medium="wax").triangles, FACES)
        self.assertEqual(len(opaline.Scene([Mesh(), octahedron()]).objects), 2)

    def test_triangles_that_make_no_sense(self):
        for name, faces in {"beyond": FACES + 1, "negative": FACES - 1, "fractions": FACES + 0.5, "columns": FACES[:, :2],
                            "huge": FACES.astype(np.int64) + 2**33}.items():
            with self.subTest(name), self.assertRaises(opaline.UsageError):
                opaline.Object(CORNERS, faces)
        with self.assertRaises(opaline.UsageError):
            opaline.Object(CORNERS)


if __name__ == "__main__":
    unittest.main()
