"""With little memory the program renders or reports the lack; it never crashes."""

import os
import resource
import signal
import unittest

from program import ProgramTest

STILL = ("render", "--builtin", "teapot", "--max-surfels", 1024, "--max-clusters", 64, "--size", "48x32", "--antialias", 1,
         "--quiet", "-o", "a.png")


def bytes_of(megabytes):
    return megabytes * 1_000_000


class Memory(ProgramTest):
    def under(self, kind, megabytes):
        return self.run_program(*STILL, preexec_fn=lambda: resource.setrlimit(kind, (bytes_of(megabytes),) * 2))

    def test_a_small_address_space(self):
        for megabytes in range(200, 1400, 240):
            with self.subTest(megabytes=megabytes):
                run = self.under(resource.RLIMIT_AS, megabytes)
                self.assertIn(run.status, (0, 1), run.err)
                self.assertEqual(len(run.err.splitlines()), run.status, run.err)
                self.assertEqual(self.listing(), ["a.png"] if run.status == 0 else [])
                (self.folder / "a.png").unlink(missing_ok=True)
        self.assertEqual(self.under(resource.RLIMIT_AS, 8000).status, 0)

    def test_a_scene_is_told_of_without_room_for_drivers(self):
        run = self.succeed("info", "--builtin", "teapot", preexec_fn=lambda: resource.setrlimit(
            resource.RLIMIT_AS, (bytes_of(200),) * 2))
        self.assertIn("2256 triangles", run.out)
        self.assertIn("list the devices", run.err)

    def test_a_limit_of_our_own(self):
        self.refused(1, *STILL, "--memory-limit", 100, says="MB")
        huge = ("8192x8192" if word == "48x32" else word for word in STILL)
        self.refused(1, *huge, "--memory-limit", 1000, says="MB")
        self.assertEqual(self.listing(), [])
        self.succeed(*STILL, "--memory-limit", 4000)
        self.refused(2, *STILL, "--memory-limit", 3, says=("memory-limit", "from 64"))

    def test_errors_keep_their_status_whatever_drivers_do_at_the_end(self):
        crashing = os.environ | {"LD_PRELOAD": os.environ["CRASHING_END"]}
        self.assertEqual(self.run_program("--version", env=crashing).status, -signal.SIGSEGV)
        self.refused(1, *STILL, "--memory-limit", 100, says="MB", env=crashing)
        self.refused(2, "render", "--size", "wide", says="size", env=crashing)


if __name__ == "__main__":
    unittest.main()
