"""Rays by VK_KHR_ray_query on a software device that has it, which scripts/fetch-ray-query-device.sh puts
beside the system's: the tests of rays, of pictures with and without, and the program's option."""

import os
import subprocess
import unittest

import images
import newer_device
from program import ProgramTest

HAS_QUERIES = newer_device.ENVIRONMENT


@unittest.skipUnless(newer_device.IS_THERE, newer_device.WHY_NOT)
class RayQueries(ProgramTest):
    def pass_all(self, program, tests):
        run = subprocess.run([os.environ[program], f"--gtest_filter={tests}"], env=HAS_QUERIES, check=False,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(run.returncode, 0, run.stdout[-3000:])
        self.assertRegex(run.stdout, r"\[  PASSED  \] [1-9]", "none was run")
        self.assertNotIn("SKIPPED", run.stdout)

    def test_rays_meet_what_they_should(self):
        self.pass_all("TEST_PASSES", "*RaysTest*by_ray_queries-*MeetsTheB*")

    def test_pictures_are_the_same_without(self):
        self.pass_all("TEST_BOUNDARY_RENDERER", "BoundaryRayQueryTest.*")

    def test_info_names_them(self):
        info = self.succeed("info", "--builtin", "bear", "--json", env=HAS_QUERIES).json()
        self.assertTrue(info["devices"][0]["ray_queries"])

    def test_the_program_takes_them(self):
        """And finds the surfels that a picture shows, which wants boxes beside the acceleration structure."""
        self.succeed("render", "--builtin", "bear", "--size", "48x48", "--max-surfels", "2048", "--max-clusters", "200",
                     "--aov", "surfels", "--validation", "--ray-queries", "on", "-o", "surfels.exr", env=HAS_QUERIES)
        seen = images.read_exr((self.folder / "surfels.exr").read_bytes()).covered()
        self.assertGreater(len(seen), 200)
        self.assertGreater(len({pixel[0] for pixel in seen}), 100)

    def test_the_reflection_is_the_same_without(self):
        """A half-space's, whose frames send rays for nothing but what of the sky is mirrored."""
        for queries in ("on", "off"):
            self.succeed("render", "--builtin", "teapot", "--size", "64x64", "--max-surfels", "4096", "--transport",
                         "better-dipole", "--ambient", "1,1,1", "--roughness", "0.5", "--validation", "--ray-queries", queries,
                         "-o", f"{queries}.exr", env=HAS_QUERIES)
        figures = self.succeed("compare", "on.exr", "off.exr", "--json").json()
        self.assertGreater(figures["covered_pixels"], 500)
        self.assertLess(figures["rel_rmse"], 1e-3)

    def test_area_lights_are_the_same_without(self):
        """Their shadows and what hides their mirror images are found by rays."""
        for queries in ("on", "off"):
            self.succeed("render", "--builtin", "teapot", "--size", "64x64", "--max-surfels", "4096", "--transport",
                         "better-dipole", "--disc", "20,40,20:-1,-2,-1:12:5", "--tube=-30,0,30:30,0,30:3:5", "--validation",
                         "--ray-queries", queries, "-o", f"{queries}.exr", env=HAS_QUERIES)
        figures = self.succeed("compare", "on.exr", "off.exr", "--json").json()
        self.assertGreater(figures["covered_pixels"], 500)
        self.assertLess(figures["rel_rmse"], 5e-3)


if __name__ == "__main__":
    unittest.main()
