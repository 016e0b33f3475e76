"""Mesa's software device computes with vectors of 128, 256 or 512 bits, and its subgroups are as large. Pictures are the same,
but for the rounding of what subgroups add up. At 512 bits Mesa 22.3 and 25.0 with LLVM 15 crash as they compile a texture,
vkcube's too. And they keep compiled code for later runs, and take that of one width at another, so each width has its own."""

import os
import pathlib
import unittest

import newer_device
from program import ProgramTest

WIDTHS = (128, 256)
KEPT = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "opaline"
TEAPOT = ("render", "--builtin", "teapot", "--max-surfels", 1024, "--size", "48x32", "--antialias", 1, "--quiet")
BEAR = ("render", "--builtin", "bear", "--max-surfels", 4096, "--max-clusters", 512, "--size", "48x48", "--quiet")


class VectorWidths(ProgramTest):
    def render(self, width, arguments, environment=os.environ):
        name = f"{width}.exr"
        self.succeed(*arguments, "-o", name, env={**environment, "LP_NATIVE_VECTOR_WIDTH": str(width),
                                                  "MESA_SHADER_CACHE_DIR": str(KEPT / f"width-{width}")})
        return name

    def expect_equal_bits(self, environment):
        pictures = [(self.folder / self.render(width, (*TEAPOT, "--transport", "dipole"), environment)).read_bytes()
                    for width in WIDTHS]
        self.assertEqual(pictures[0], pictures[1])

    def test_sums_that_no_subgroup_makes_are_equal_bit_by_bit(self):
        self.expect_equal_bits(os.environ)

    @unittest.skipUnless(newer_device.IS_THERE, newer_device.WHY_NOT)
    def test_so_they_are_on_a_newer_device(self):
        self.expect_equal_bits(newer_device.ENVIRONMENT)

    def test_boundary_transport_differs_by_rounding(self):
        narrow, wide = (self.render(width, BEAR) for width in WIDTHS)
        figures = self.succeed("compare", narrow, wide, "--json").json()
        self.assertLess(figures["rel_rmse"], 1e-5)
        self.assertGreater(figures["covered_pixels"], 300)


if __name__ == "__main__":
    unittest.main()
