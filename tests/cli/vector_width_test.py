"""Mesa's software device computes with vectors of 128, 256 or 512 bits, and its subgroups are as large. Pictures are the same,
but for the rounding of what subgroups add up."""

import os
import unittest

from program import ProgramTest

WIDTHS = (128, 256, 512)
TEAPOT = ("render", "--builtin", "teapot", "--max-surfels", 1024, "--size", "48x32", "--antialias", 1, "--quiet")
BEAR = ("render", "--builtin", "bear", "--max-surfels", 4096, "--max-clusters", 512, "--size", "48x48", "--quiet")


class VectorWidths(ProgramTest):
    def render(self, width, arguments):
        name = f"{width}.exr"
        self.succeed(*arguments, "-o", name, env={**os.environ, "LP_NATIVE_VECTOR_WIDTH": str(width)})
        return name

    def test_sums_that_no_subgroup_makes_are_equal_bit_by_bit(self):
        pictures = [(self.folder / self.render(width, (*TEAPOT, "--transport", "dipole"))).read_bytes() for width in WIDTHS]
        self.assertEqual(len(set(pictures)), 1)

    def test_boundary_transport_differs_by_rounding(self):
        first, *others = (self.render(width, BEAR) for width in WIDTHS)
        for other in others:
            figures = self.succeed("compare", first, other, "--json").json()
            self.assertLess(figures["rel_rmse"], 1e-5)
            self.assertGreater(figures["covered_pixels"], 300)


if __name__ == "__main__":
    unittest.main()
