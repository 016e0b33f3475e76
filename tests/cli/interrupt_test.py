"""Interrupting the program leaves whole files and nothing else."""

import os
import pathlib
import shutil
import signal
import subprocess
import time
import unittest

from images import read_exr, read_png
from program import ProgramTest

ENDLESS = ("render", "--builtin", "teapot", "--shadow-size", 64, "--transport", "dipole", "--max-surfels", 1024, "--deform", "wobble:0.1", "--frames",
           "0:9999", "--quiet")
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class Interrupt(ProgramTest):
    def interrupted(self, number, until, *arguments, size="48x32", **keywords):
        process = self.start(*ENDLESS, *arguments, "--size", size, stderr=subprocess.PIPE, **keywords)
        self.wait_for(until, process)
        process.send_signal(number)
        _, errors = process.communicate(timeout=60)
        self.assertEqual((process.returncode, errors), (-number, b""), "the shell sees the signal")

    def some(self, pattern):
        return any(self.folder.glob(pattern))

    def test_pictures_are_whole(self):
        for number in SIGNALS:
            for kind, read in (("png", read_png), ("exr", read_exr)):
                with self.subTest(signal=number, kind=kind):
                    self.interrupted(number, lambda: self.some(f"f*.{kind}"), "-o", f"f%d.{kind}")
                    self.assertTrue(self.listing())
                    for name in self.listing():
                        self.assertRegex(name, rf"^f\d+\.{kind}$")
                        picture = read((self.folder / name).read_bytes())
                        self.assertEqual((picture.width, picture.height), (48, 32))
                        (self.folder / name).unlink()

    def test_in_the_middle_of_writing(self):
        for _ in range(3):
            self.interrupted(signal.SIGINT, lambda: self.some(".opaline-*"), "--aov", "position", "-o", "f%d.exr",
                             size="800x600")
            self.assertFalse(self.some(".*"), self.listing())

    def leftovers(self):
        return [name for name in self.listing() if name.startswith(".")]

    def kill(self, until, *arguments):
        process = self.start(*ENDLESS, *arguments, "--size", "400x300", "--aov", "position", stderr=subprocess.DEVNULL)
        self.wait_for(until, process)
        process.kill()
        process.wait()

    def test_killed_in_the_middle_of_writing(self):
        """Nobody can clean up in that case; the next program that writes there does."""
        for _ in range(6):
            left = set(self.leftovers())
            self.kill(lambda: set(self.leftovers()) - left, "--resume", "-o", "f%d.exr")
            self.assertEqual(left & set(self.leftovers()), set(), "each run clears what the one before it left")
            for name in set(self.listing()) - set(self.leftovers()):
                self.assertEqual(read_exr((self.folder / name).read_bytes()).width, 400)
        self.succeed(*ENDLESS[:-2], "0:1", "--quiet", "--size", "400x300", "--aov", "position", "--resume", "-o", "f%d.exr")
        self.assertEqual(self.leftovers(), [])

    def test_two_at_once_in_one_folder(self):
        film = (*ENDLESS[:-2], "0:5", "--quiet", "--size", "64x48", "-o", "f%d.png")
        both = [self.start(*film, stderr=subprocess.PIPE) for _ in range(2)]
        for process in both:
            self.assertEqual(process.communicate(timeout=200)[1], b"")
            self.assertEqual(process.returncode, 0)
        self.assertEqual(self.listing(), [f"f{i}.png" for i in range(6)])
        together = [(self.folder / name).read_bytes() for name in self.listing()]
        self.succeed(*film)
        self.assertEqual([(self.folder / name).read_bytes() for name in self.listing()], together)

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_a_film_is_whole_or_not_there(self):
        for number in SIGNALS:
            self.interrupted(number, lambda: self.some(".opaline-*.mp4"), "-o", "film.mp4")
            self.assertEqual(self.listing(), [])

    def test_no_child_stays_behind(self):
        tools = self.folder / "tools"
        tools.mkdir()
        (tools / "ffmpeg").write_text("#!/bin/sh\necho $$ > child.new\nmv child.new child\nexec cat >/dev/null\n")
        (tools / "ffmpeg").chmod(0o755)
        env = {**os.environ, "PATH": f"{tools}:/usr/bin:/bin"}
        self.interrupted(signal.SIGTERM, (self.folder / "child").exists, "-o", "film.mp4", env=env)
        child = int((self.folder / "child").read_text())
        deadline = time.monotonic() + 10
        while self.is_there(child) and time.monotonic() < deadline:
            time.sleep(.01)  # until whoever adopts orphans has seen that it died
        self.assertFalse(self.is_there(child))
        self.assertEqual(self.listing(), ["child", "tools"])

    @staticmethod
    def is_there(process):
        """Whether a process exists; dead ones that were not reaped do not count."""
        try:
            state = pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0]
        except OSError:
            return False
        return state not in "ZX"

    def test_what_is_ignored_stays_ignored(self):
        # As after nohup: the SIGHUP is ignored, the SIGTERM after it ends the program.
        process = self.start(*ENDLESS, "--size", "48x32", "-o", "f%d.png", ignored=(signal.SIGHUP,))
        self.wait_for(lambda: self.some("f*.png"), process)
        process.send_signal(signal.SIGHUP)
        here = len(self.listing())
        self.wait_for(lambda: len(self.listing()) > here + 5, process)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(60), -signal.SIGTERM)


if __name__ == "__main__":
    unittest.main()
