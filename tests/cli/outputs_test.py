"""Failures to write are reported, before the work where possible."""

import os
import subprocess
import unittest

from program import PROGRAM, ProgramTest


class StandardOutput(ProgramTest):
    def test_full(self):
        with open("/dev/full", "wb") as full:
            run = self.refused(1, "media", stdout=full, says="standard output")
        self.assertIn("No space left", run.err)

    def test_closed(self):
        done = subprocess.run(["sh", "-c", 'exec "$0" media >&-', PROGRAM], capture_output=True, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"standard output", done.stderr)

    def test_a_reader_that_leaves_is_no_news(self):
        for arguments in (("profile", "--samples", "100000"), ("media",), ("media", "--json"), ("--help",)):
            # As after `opaline media | head -1`, but without a race: nobody ever reads.
            reading, writing = os.pipe()
            os.close(reading)
            done = subprocess.run([PROGRAM, *arguments], stdout=writing, stderr=subprocess.PIPE, timeout=60)
            os.close(writing)
            self.assertEqual((done.returncode, done.stderr), (1, b""), arguments)


class Files(ProgramTest):
    def test_what_cannot_be_written_is_refused_before_work(self):
        (self.folder / "folder.png").mkdir()
        (self.folder / "folder.svg").mkdir()
        (self.folder / "folder.json").mkdir()
        # The scene does not exist either: the complaint about the output shows the order of checks.
        for arguments in [("render", "no.ply", "-o", "missing/a.png"), ("render", "no.ply", "-o", "folder.png"),
                          ("render", "no.ply", "--report", "missing/a.json"),
                          ("render", "no.ply", "--report", "folder.json"),
                          ("reference", "no.ply", "--integral", "-o", "missing/a.exr"),
                          ("info", "no.ply", "--atlas", "missing/a.png"), ("info", "no.ply", "--atlas", "folder.png"),
                          ("profile", "--plot", "missing/a.svg"), ("profile", "--plot", "folder.svg")]:
            with self.subTest(arguments=arguments):
                self.refused(1, *arguments, says=arguments[-1])
        self.assertEqual(self.listing(), ["folder.json", "folder.png", "folder.svg"])

    def test_devices_and_pipes_are_not_replaced(self):
        (self.folder / "full.svg").symlink_to("/dev/full")
        os.mkfifo(self.folder / "pipe.svg")
        for name in ("full.svg", "pipe.svg"):
            self.refused(1, "profile", "--plot", name, says=(name, "not a regular file"))
        self.assertTrue((self.folder / "full.svg").is_symlink())

    def test_a_file_that_is_there_is_replaced_whole(self):
        self.write("a.svg", "x" * 1000000)
        self.succeed("profile", "--plot", "a.svg")
        self.assertTrue((self.folder / "a.svg").read_text().endswith("</svg>\n"))
        self.assertEqual(self.listing(), ["a.svg"])


if __name__ == "__main__":
    unittest.main()
