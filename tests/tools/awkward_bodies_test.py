"""The bodies of the contact sheet are what their names say."""

import collections
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))

from awkward_bodies import BODIES


def open_edges(triangles):
    edges = collections.Counter((a, b) for t in triangles for a, b in zip(t, t[1:] + t[:1]))
    return sum(edges[a, b] != edges[b, a] for a, b in list(edges))


def volume(vertices, triangles):
    total = 0
    for a, b, c in ([vertices[i] for i in t] for t in triangles):
        total += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                  + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    return total


class Bodies(unittest.TestCase):
    def test_all_but_the_quad_are_closed(self):
        for name, (_, triangles) in BODIES.items():
            self.assertEqual(open_edges(triangles), 4 if name == "quad" else 0, name)

    def test_only_one_is_inside_out(self):
        for name, body in BODIES.items():
            if name != "quad":
                self.assertEqual(volume(*body) < 0, name == "inside_out", name)

    def test_their_volumes(self):
        self.assertAlmostEqual(volume(*BODIES["cube"]), 1)
        self.assertAlmostEqual(volume(*BODIES["plate"]), .01)
        self.assertAlmostEqual(volume(*BODIES["rod"]), .0004)


if __name__ == "__main__":
    unittest.main()
