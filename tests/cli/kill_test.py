"""A kill at any moment leaves whole files, and continuing gives the result of a single run."""

import os
import random
import shutil
import signal
import subprocess
import time
import unittest

from images import read_exr, read_png
from program import ProgramTest

FILM = ("render", "--builtin", "teapot", "--shadow-size", 64, "--transport", "dipole", "--max-surfels", 1024, "--size",
        "40x30", "--deform", "wobble:0.1", "--quiet")


class Kills(ProgramTest):
    def setUp(self):
        super().setUp()
        self.random = random.Random(22)

    def kill_until_done(self, *arguments, seconds):
        """Starts the program again and again and kills it at random moments, until a run finishes. A whole run takes
        about `seconds`. Returns the number of kills."""
        for kills in range(60):
            process = self.start(*arguments, stderr=subprocess.PIPE)
            try:
                # In the end it may take its time.
                _, errors = process.communicate(timeout=seconds * (1 + kills / 4) * self.random.uniform(.1, .9))
            except subprocess.TimeoutExpired:
                process.kill()
                process.communicate()
                continue
            self.assertEqual((process.returncode, errors), (0, b""))
            return kills
        return self.fail("it never came to its end")

    def frames(self):
        return {path.name: path.read_bytes() for path in self.folder.iterdir()}

    def test_films_that_are_gone_on_with_are_those_of_one_run(self):
        for kind, read in (("png", read_png), ("exr", read_exr)):
            film = (*FILM, "--frames", "0:9", "-o", f"f%d.{kind}")
            begun = time.monotonic()
            self.succeed(*film)
            seconds = time.monotonic() - begun
            whole = self.frames()
            self.assertEqual(len(whole), 10)
            kills = 0
            while kills == 0:  # it may be quicker than before
                for name in whole:
                    (self.folder / name).unlink()
                kills = self.kill_until_done(*film, "--resume", seconds=seconds)
            self.assertEqual(self.frames(), whole)
            for name, data in whole.items():
                self.assertEqual(read(data).width, 40)
                (self.folder / name).unlink()

    def test_what_is_there_after_a_kill_is_whole(self):
        film = (*FILM, "--frames", "0:999", "-o", "f%d.png")
        for _ in range(6):
            process = self.start(*film, stderr=subprocess.DEVNULL)
            time.sleep(self.random.uniform(.3, .9))
            process.kill()
            process.wait()
            for name, data in self.frames().items():
                if not name.startswith(".opaline-"):
                    self.assertEqual(read_png(data).width, 40)
        self.succeed(*FILM, "--frames", "0:0", "-o", "f%d.png")
        self.assertFalse([name for name in self.frames() if name.startswith(".")])

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_a_killed_film_leaves_the_old_one(self):
        film = (*FILM, "--frames", "0:9999", "-o", "film.mp4")
        self.write("film.mp4", "an older film")
        for _ in range(4):
            process = self.start(*film, stderr=subprocess.DEVNULL)
            its_own = f".opaline-{process.pid}-*.mp4"  # that of the last kill may still be there
            self.wait_for(lambda: any(self.folder.glob(its_own)), process)
            time.sleep(self.random.uniform(0, .5))
            process.kill()
            process.wait()
            self.assertEqual((self.folder / "film.mp4").read_bytes(), b"an older film")
        self.succeed(*FILM, "--frames", "0:1", "-o", "film.mp4")
        self.assertEqual(self.listing(), ["film.mp4"])
        self.assertIn(b"ftyp", (self.folder / "film.mp4").read_bytes()[:12])

    def test_an_encoder_that_dies_in_the_middle(self):
        tools = self.folder / "tools"
        tools.mkdir()
        env = {**os.environ, "PATH": f"{tools}:/usr/bin:/bin"}
        for bytes_taken in (1, 3600, 20000):
            for end in ("exit 3", "kill -9 $$", "exit 0"):
                with self.subTest(bytes=bytes_taken, end=end):
                    (tools / "ffmpeg").write_text(f"#!/bin/sh\nhead -c {bytes_taken} >/dev/null\n{end}\n")
                    (tools / "ffmpeg").chmod(0o755)
                    self.refused(1, *FILM, "--frames", "0:60", "-o", "film.mp4", env=env, says="film.mp4")
                    self.assertEqual(self.listing(), ["tools"])


class Checkpoints(ProgramTest):
    PATHS = ("reference", "--builtin", "teapot", "--path", "--samples", 60000, "--size", "8x6", "--quiet", "-o", "a.exr")

    def pixels(self):
        return list(read_exr((self.folder / "a.exr").read_bytes()).pixels())

    def test_killed_runs_go_on_to_the_same_picture(self):
        self.succeed(*self.PATHS)
        whole = self.pixels()
        kept = (*self.PATHS, "--checkpoint", "state")
        # A signal that may be heeded, too.
        for seed, number in enumerate((signal.SIGKILL, signal.SIGTERM, signal.SIGKILL, signal.SIGINT)):
            process = self.start(*kept, stderr=subprocess.DEVNULL)
            time.sleep(random.Random(seed).uniform(.1, .6))
            process.send_signal(number)
            process.wait()
        self.succeed(*kept)
        self.assertEqual(self.pixels(), whole)
        self.assertEqual(self.listing(), ["a.exr", "state"])

    def test_two_at_once_do_not_harm_each_other(self):
        self.succeed(*self.PATHS)
        whole = self.pixels()
        both = [self.start(*self.PATHS, "--checkpoint", "state", stderr=subprocess.DEVNULL) for _ in range(2)]
        self.assertEqual([process.wait(200) for process in both], [0, 0])
        self.assertEqual(self.pixels(), whole)
        self.succeed(*self.PATHS, "--checkpoint", "state")
        self.assertEqual(self.pixels(), whole)


if __name__ == "__main__":
    unittest.main()
