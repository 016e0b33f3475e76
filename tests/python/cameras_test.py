"""Shifted and orthographic cameras show what they must, by arithmetic."""

import unittest

import numpy as np
from bodies import scene

import opaline

PLACE, TARGET = (20.0, 30.0, 60.0), (1.0, -2.0, 3.0)


def axes():
    """Right, up and ahead."""
    ahead = np.subtract(TARGET, PLACE) / np.linalg.norm(np.subtract(TARGET, PLACE))
    right = np.cross(ahead, (0, 1, 0))
    right /= np.linalg.norm(right)
    return right, np.cross(right, ahead), ahead


class Cameras(unittest.TestCase):
    WIDTH, HEIGHT = 48, 32

    def setUp(self):
        self.renderer = opaline.Renderer(scene())

    def picture(self, aovs=("position", "depth"), width=WIDTH, height=HEIGHT, **camera):
        return self.renderer.render(width, height, list(aovs), camera=opaline.Camera(PLACE, TARGET, **camera), transport="dipole")

    def test_parallel_sight(self):
        right, up, ahead = axes()
        for shift in ((0, 0), (0.1, -0.2)):
            height_mm = 26
            frame = self.picture(orthographic_height_mm=height_mm, shift_x=shift[0], shift_y=shift[1])
            covered = frame["position"][..., 3] > 0
            self.assertGreater(covered.mean(), 0.1)
            rows, columns = np.nonzero(covered)
            offset = frame["position"][covered][:, :3] - PLACE
            across = height_mm * self.WIDTH / self.HEIGHT * ((columns + 0.5) / self.WIDTH - 0.5 + shift[0])
            above = height_mm * (0.5 - (rows + 0.5) / self.HEIGHT + shift[1])
            np.testing.assert_allclose(offset @ right, across, atol=2e-3)
            np.testing.assert_allclose(offset @ up, above, atol=2e-3)
            np.testing.assert_allclose(frame["depth"][covered][:, 0], offset @ ahead, atol=2e-3)

    def test_what_lies_behind_an_orthographic_camera_is_not_seen(self):
        camera = opaline.Camera((0, 0, 0), (0, 0, -1), orthographic_height_mm=30)
        frame = self.renderer.render(24, 16, ["position"], camera=camera, transport="dipole")
        seen = frame["position"][frame["position"][..., 3] > 0]
        self.assertGreater(len(seen), 0)
        self.assertLessEqual(seen[:, 2].max(), 1e-3)

    def test_a_shifted_part_is_that_of_the_whole(self):
        fov = 24
        whole = self.picture(vertical_fov_degrees=fov)
        # Columns 12 to 36 and rows 4 to 20.
        tangent = np.tan(np.radians(fov / 2))
        part = self.picture(width=24, height=16, vertical_fov_degrees=2 * np.degrees(np.arctan(tangent / 2)), shift_x=0,
                            shift_y=(16 - 12) / 16)
        for name in ("position", "depth"):
            np.testing.assert_allclose(part[name], whole[name][4:20, 12:36], atol=2e-3)

    def test_the_reference_has_the_same_cameras(self):
        body = scene()
        for more in ({"shift_x": 0.2, "shift_y": -0.1}, {"orthographic_height_mm": 30, "shift_x": 0.1}):
            body.camera = opaline.Camera(PLACE, TARGET, vertical_fov_degrees=24, **more)
            truth = opaline.integral(body, 24, 16, "position")["position"]
            found = opaline.Renderer(body).render(24, 16, "position", transport="dipole")["position"]
            same = (truth[..., 3] > 0) == (found[..., 3] > 0)
            self.assertGreater(same.mean(), 0.98)
            both = (truth[..., 3] > 0) & (found[..., 3] > 0)
            np.testing.assert_allclose(found[both][:, :3], truth[both][:, :3], atol=5e-3)

    def test_refusals(self):
        for more in ({"orthographic_height_mm": 0}, {"shift_x": 1001}, {"shift_y": float("nan")}):
            with self.assertRaises(opaline.UsageError):
                opaline.Camera(PLACE, TARGET, **more)


if __name__ == "__main__":
    unittest.main()
