"""`render --frames`: numbered pictures and films."""

import base64
import fcntl
import json
import math
import os
import pty
import re
import resource
import shutil
import struct
import subprocess
import termios
import unittest

from images import read_exr, read_png
from program import PROGRAM, ProgramTest

# Films work with any transport; this one is quick.
MODEL = ("--builtin", "teapot", "--shadow-size", 64, "--transport", "dipole", "--max-surfels", 1024)
MOTION = ("--deform", "wobble:0.1:0.7", "--deform", "twist:0.5:1.5")
TEAPOT = (*MODEL, "--fov-degrees", 50, "--size", "24x16")
MOVING = (*TEAPOT, *MOTION)
HAVE_FFMPEG = shutil.which("ffmpeg") and shutil.which("ffprobe")


class Film(ProgramTest):
    def bytes_of(self, name):
        return (self.folder / name).read_bytes()

    def pixels_of(self, name):
        read = read_png if name.endswith(".png") else read_exr
        return read(self.bytes_of(name)).rows

    def fake_ffmpeg(self, script):
        """An environment in which this shell script is the only ffmpeg."""
        tools = self.folder / "tools"
        tools.mkdir()
        (tools / "ffmpeg").write_text("#!/bin/sh\n" + script)
        (tools / "ffmpeg").chmod(0o755)
        return {**os.environ, "PATH": f"{tools}:/usr/bin:/bin"}


class Pictures(Film):
    def test_each_is_the_still_of_its_time(self):
        self.succeed("render", *MOVING, "--frames", "2:4", "--fps", "4", "-o", "f_%03d.png")
        self.assertEqual(self.listing(), ["f_002.png", "f_003.png", "f_004.png"])
        for frame in (2, 3, 4):
            self.succeed("render", *MOVING, "--time", frame / 4, "-o", "still.png")
            self.assertEqual(self.pixels_of("still.png"), self.pixels_of(f"f_{frame:03}.png"), frame)

    def most_memory(self, frames, *options):
        """Peak memory of the process in MB. The address sanitizer would keep freed memory."""
        process = self.start("render", *MOVING, "--frames", f"0:{frames}", "--quiet", *options,
                             env={**os.environ, "ASAN_OPTIONS": "quarantine_size_mb=1"})
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 0)
        return used.ru_maxrss / 1024

    def test_more_frames_need_no_more_memory(self):
        for options in (("-o", "f%d.png"), ("--aov", "exitance", "-o", "f%d.exr")):
            with self.subTest(options=options):
                few, many = (self.most_memory(frames, *options) for frames in (5, 80))
                self.assertLess(many, few + 16)

    def test_what_moves_differs_from_frame_to_frame(self):
        for motion in ("twist:0.6:2", "bend:0.8:2", "squash:0.4:2", "wobble:0.1:2"):
            self.succeed("render", *TEAPOT, "--deform", motion, "--frames", "1:2", "--fps", 4, "-o", "f%d.png")
            self.assertNotEqual(self.pixels_of("f1.png"), self.pixels_of("f2.png"), motion)
        # A swing begins at rest.
        self.succeed("render", *TEAPOT, "--deform", "squash:0.4:2", "--time", 0, "-o", "swing.png")
        self.succeed("render", *TEAPOT, "-o", "rest.png")
        self.succeed("render", *TEAPOT, "--deform", "squash:0.4", "-o", "held.png")
        self.assertEqual(self.bytes_of("swing.png"), self.bytes_of("rest.png"))
        self.assertNotEqual(self.bytes_of("held.png"), self.bytes_of("rest.png"))

    def test_exr_and_other_variables(self):
        self.succeed("render", *MOVING, "--frames", "9:10", "--aov", "position", "-o", "p%d.exr")
        self.assertEqual(self.listing(), ["p10.exr", "p9.exr"])
        self.succeed("render", *MOVING, "--time", 10 / 30, "--aov", "position", "-o", "still.exr")
        self.assertEqual(self.pixels_of("still.exr"), self.pixels_of("p10.exr"))

    def test_names_without_o_follow_the_scene(self):
        self.succeed("render", *MOVING, "--frames", "0:0", "--quiet")
        self.succeed("render", *MOVING, "--frames", "1:1", "--aov", "depth", "--quiet")
        self.assertEqual(self.listing(), ["teapot_0000.png", "teapot_0001.exr"])

    def test_a_mark_that_is_none_is_a_name(self):
        self.succeed("render", *TEAPOT, "-o", "100%.png")
        self.succeed("render", *MOVING, "--frames", "7:7", "-o", "100%_%02d%.png")
        self.assertEqual(self.listing(), ["100%.png", "100%_07%.png"])

    def test_report(self):
        run = self.succeed("render", *MOVING, "--frames", "0:2", "--fps", "12.5", "-o", "f%d.png", "--json",
                           "--report", "r.json")
        report = run.json()
        self.assertEqual(report, json.loads(self.bytes_of("r.json")))
        self.assertEqual(report["outputs"], ["f0.png", "f1.png", "f2.png"])
        self.assertEqual((report["frames"], report["fps"]), ([0, 2], 12.5))
        self.assertGreater(report["frame_ms"], 0)
        self.assertIn("wrote 3 frames", run.err)

    def test_what_stands_still_is_said(self):
        still = self.succeed("render", *TEAPOT, "--frames", "0:1", "-o", "f%d.png")
        self.assertIn("nothing in the scene moves", still.err)
        self.assertEqual(self.pixels_of("f0.png"), self.pixels_of("f1.png"))
        held = self.succeed("render", *TEAPOT, "--deform", "twist:0.5", "--frames", "0:1", "-o", "f%d.png")
        self.assertIn("nothing in the scene moves", held.err)
        moving = self.succeed("render", *MOVING, "--frames", "0:1", "-o", "f%d.png")
        self.assertNotIn("nothing in the scene moves", moving.err)

    def test_no_clip_can_be_asked_for(self):
        self.succeed("render", *TEAPOT, "--clip", "none", "-o", "a.png")

    def test_a_place_that_cannot_be_written_is_refused_before_work(self):
        (self.folder / "f3.png").mkdir()
        self.refused(1, "render", "no.ply", "--frames", "3:4", "-o", "f%d.png", says="f3.png")
        self.refused(1, "render", "no.ply", "--frames", "3:4", "-o", "none/f%d.png", says="none")
        self.refused(2, "render", "no.ply", "--frames", "0:4:2", "-o", "f.mp4", says="numbered pictures")

    def test_a_place_that_cannot_be_written_later_ends_it(self):
        (self.folder / "f1.png").mkdir()
        self.refused(1, "render", *MOVING, "--frames", "0:3", "-o", "f%d.png", says="f1.png")
        for name in self.listing():
            self.assertRegex(name, r"^f\d\.png$")

    def test_a_full_disk_is_one_sentence(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))
        for name in ("f%d.png", "f%d.exr"):
            self.refused(1, "render", *MOVING, "--frames", "0:3", "-o", name, preexec_fn=limit, says="Cannot write f")
        self.assertEqual(self.listing(), [])


class Resume(Film):
    def test_whole_pictures_stay_and_others_are_made(self):
        for kind, read in (("png", read_png), ("exr", read_exr)):
            with self.subTest(kind=kind):
                arguments = ("render", *MOVING, "--frames", "0:5", "-o", f"f%d.{kind}")
                self.succeed(*arguments)
                names = [f"f{i}.{kind}" for i in range(6)]
                before = [self.bytes_of(name) for name in names]
                (self.folder / names[1]).unlink()
                self.write(names[2], before[2][:-1])
                self.write(names[3], b"")
                self.succeed("render", *MODEL, *MOTION, "--size", "23x16", "--time", 0, "-o", names[4])
                marks = [(self.folder / names[i]).stat().st_mtime_ns for i in (0, 5)]
                run = self.succeed(*arguments, "--resume")
                self.assertIn("2 of 6 frames existed already", run.err)
                self.assertIn("wrote 4 frames", run.err)
                self.assertEqual([self.bytes_of(name) for name in names], before)
                self.assertEqual([(self.folder / names[i]).stat().st_mtime_ns for i in (0, 5)], marks)

    def test_nothing_left_to_do(self):
        arguments = ("render", *MOVING, "--frames", "0:1", "-o", "f%d.png", "--resume")
        self.assertNotIn("already", self.succeed(*arguments).err)
        run = self.succeed(*arguments, "--json")
        self.assertIn("2 of 2 frames existed already", run.err)
        self.assertNotIn("wrote", run.err)
        self.assertEqual((run.json()["frame_ms"], run.json()["outputs"]), (None, ["f0.png", "f1.png"]))
        self.assertEqual((run.json()["transport"], run.json()["site"]), (None, None))


def dented(height):
    """An octahedron, one side of which is a pyramid; all of them have one box and one topology."""
    corners = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1), (height, height, height)]
    sides = [(0, 2, 6), (2, 4, 6), (4, 0, 6), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5),
             (0, 3, 5)]
    header = ("ply\nformat ascii 1.0\nelement vertex 7\nproperty float x\nproperty float y\nproperty float z\n"
              "element face 10\nproperty list uchar int vertex_indices\nend_header\n")
    return header + "".join(f"{x} {y} {z}\n" for x, y, z in corners) + "".join(f"3 {a} {b} {c}\n" for a, b, c in sides)


class Sequence(Film):
    HEIGHTS = (.34, .45, .6, .5)
    OPTIONS = ("--size", "24x16", "--shadow-size", 64, "--fov-degrees", 50, "--transport", "dipole", "--max-surfels", 1024)

    def setUp(self):
        super().setUp()
        for number, height in enumerate(self.HEIGHTS):
            self.write(f"m_{number + 7:02}.ply", dented(height))

    def test_each_frame_shows_its_file(self):
        run = self.succeed("render", "m_%02d.ply", *self.OPTIONS, "--frames", "0:3", "--aov", "depth", "-o", "f%d.exr")
        self.assertNotIn("nothing in the scene moves", run.err)
        for frame in range(4):
            self.succeed("render", f"m_{frame + 7:02}.ply", *self.OPTIONS, "--aov", "depth", "-o", "alone.exr")
            got, wanted = read_exr(self.bytes_of(f"f{frame}.exr")), read_exr(self.bytes_of("alone.exr"))
            for a, b in zip(got.pixels(), wanted.pixels(), strict=True):
                self.assertEqual(a[3], b[3])
                self.assertAlmostEqual(a[0], b[0], delta=1e-4 * b[0])
        self.assertNotEqual(self.pixels_of("f0.exr"), self.pixels_of("f2.exr"))

    def test_stills_and_what_is_left_of_a_film(self):
        film = ("render", "m_%02d.ply", *self.OPTIONS, "--frames", "0:3", "-o", "f%d.png")
        self.succeed(*film)
        before = [self.bytes_of(f"f{frame}.png") for frame in range(4)]
        self.succeed("render", "m_%02d.ply", *self.OPTIONS, "--time", 2 / 30, "-o", "still.png")
        self.assertEqual(self.pixels_of("still.png"), self.pixels_of("f2.png"))
        for frame in (1, 3):
            (self.folder / f"f{frame}.png").unlink()
        self.succeed(*film, "--resume")
        self.assertEqual([self.bytes_of(f"f{frame}.png") for frame in range(4)], before)

    def test_a_scene_file_names_a_sequence(self):
        self.write("scene.toml", 'model = "m_%02d.ply"\n')
        for name in ("m_%02d.ply", "scene.toml"):
            self.succeed("render", name, *self.OPTIONS, "--frames", "1:2", "-o", name[0] + "%d.png")
        for frame in (1, 2):
            self.assertEqual(self.pixels_of(f"m{frame}.png"), self.pixels_of(f"s{frame}.png"))
        self.refused(2, "render", "scene.toml", *self.OPTIONS, "--time", 1, "-o", "a.png", says="m_10.ply")

    def test_names_follow_the_pattern(self):
        self.succeed("render", "m_%02d.ply", *self.OPTIONS, "--frames", "0:0")
        self.succeed("render", "m_%02d.ply", *self.OPTIONS)
        self.assertEqual([name for name in self.listing() if name.endswith(".png")], ["m.png", "m_0000.png"])

    def test_beyond_the_last(self):
        self.refused(2, "render", "m_%02d.ply", *self.OPTIONS, "--frames", "0:4", "-o", "f%d.png",
                     says="frame 4 is beyond the last of the sequence's 4 files: frame 3 shows m_10.ply.")
        self.refused(2, "render", "m_%02d.ply", *self.OPTIONS, "--time", 1, "-o", "a.png", says="m_10.ply")
        self.refused(1, "render", "no_%02d.ply", *self.OPTIONS, "-o", "a.png", says="no_")

    def test_a_file_that_does_not_fit_ends_it(self):
        self.write("m_09.ply", dented(.5).replace("3 0 3 5", "3 0 3 4"))
        self.refused(1, "render", "m_%02d.ply", *self.OPTIONS, "--frames", "0:3", "-o", "f%d.png", says="m_09.ply")


def walker():
    """A tetrahedron with two clips of a second: "walk" goes along x, "jump" along y."""
    points = struct.pack("<12f", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1)
    sides = struct.pack("<12H", 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3)
    keys = struct.pack("<14f", 0, 1, 0, 0, 0, .5, 0, 0, 0, 0, 0, 0, .5, 0)
    data = points + sides + keys
    start = len(points) + len(sides)
    views = [(0, 48), (48, 24), (start, 8), (start + 8, 24), (start + 32, 24)]
    accessor = {"byteOffset": 0, "componentType": 5126, "count": 2, "type": "VEC3"}

    def clip(name, output):
        return {"name": name, "samplers": [{"input": 2, "output": output}],
                "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": len(data),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
        "bufferViews": [{"buffer": 0, "byteOffset": at, "byteLength": size} for at, size in views],
        "accessors": [{**accessor, "bufferView": 0, "count": 4, "min": [0, 0, 0], "max": [1, 1, 1]},
                      {**accessor, "bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"},
                      {**accessor, "bufferView": 2, "type": "SCALAR", "min": [0], "max": [1]},
                      {**accessor, "bufferView": 3}, {**accessor, "bufferView": 4}],
        "animations": [clip("walk", 3), clip("jump", 4)]})


class Clips(Film):
    OPTIONS = ("--size", "24x16", "--shadow-size", 64, "--max-surfels", 1024, "--diagonal-mm", 30, "--fov-degrees", 60,
               "--aov", "position", "-o", "a.exr")

    def setUp(self):
        super().setUp()
        self.write("walker.gltf", walker())

    def middle(self, *arguments):
        """The middle of its visible part."""
        self.succeed("render", "walker.gltf", *self.OPTIONS, *arguments)
        covered = [pixel for pixel in read_exr(self.bytes_of("a.exr")).pixels() if pixel[3] == 1]
        self.assertGreater(len(covered), 10)
        return [sum(pixel[axis] for pixel in covered) / len(covered) for axis in range(2)]

    def test_the_first_plays_unless_another_is_named(self):
        rest = self.middle("--clip", "none", "--time", .5)
        step = 30 / math.sqrt(3) / 4  # half of half an edge of the box
        for clip, moved in (((), (step, 0)), (("--clip", "walk"), (step, 0)), (("--clip", "jump"), (0, step))):
            middle = self.middle(*clip, "--time", .5)
            for axis in range(2):
                self.assertAlmostEqual(middle[axis] - rest[axis], moved[axis], delta=.15 * step)

    def test_a_name_that_is_none_lists_those_there_are(self):
        self.refused(2, "render", "walker.gltf", "--clip", "jmup", says=("--clip jmup", "none, walk, jump",
                                                                        "did you mean jump?"))

    def test_morph_to(self):
        self.write("a.ply", dented(.34))
        self.write("b.ply", dented(.6))
        # The clip "morph" lasts 4 s and is back at its end.
        run = self.succeed("render", "a.ply", "--morph-to", "b.ply", *self.OPTIONS, "--time", 2)
        morphed = read_exr(self.bytes_of("a.exr"))
        self.succeed("render", "b.ply", *self.OPTIONS)
        for got, wanted in zip(morphed.pixels(), read_exr(self.bytes_of("a.exr")).pixels(), strict=True):
            for a, b in zip(got, wanted):
                self.assertAlmostEqual(a, b, delta=2e-3)
        self.assertNotIn("nothing in the scene moves", run.err)
        self.write("c.ply", dented(.6).replace("3 0 3 5", "3 0 3 4"))
        self.refused(1, "render", "a.ply", "--morph-to", "c.ply", says="c.ply")


class Mp4(Film):
    def probe(self, name, entries):
        done = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v", "-show_entries",
                               f"stream={entries}", "-of", "json", self.folder / name], capture_output=True, check=True)
        return json.loads(done.stdout)["streams"][0]

    def decoded(self, name, *filters):
        """The frames as RGB bytes."""
        return subprocess.run(["ffmpeg", "-v", "error", "-i", self.folder / name, *filters, "-f", "rawvideo",
                               "-pix_fmt", "rgb24", "-"], capture_output=True, check=True).stdout

    @unittest.skipUnless(HAVE_FFMPEG, "ffmpeg and ffprobe are not installed")
    def test_what_every_player_wants(self):
        self.write("film.mp4", "an old one")
        run = self.succeed("render", *MODEL, *MOTION, "--size", "33x17", "--frames", "3:8", "--fps", "12", "-o", "film.mp4",
                           "--json")
        self.assertEqual(run.json()["outputs"], ["film.mp4"])
        self.assertEqual(self.listing(), ["film.mp4"])
        wanted = {"codec_name": "h264", "pix_fmt": "yuv420p", "width": 34, "height": 18, "nb_read_frames": "6",
                  "r_frame_rate": "12/1", "color_space": "bt709", "color_primaries": "bt709",
                  "color_transfer": "bt709", "color_range": "tv"}
        self.assertEqual(self.probe("film.mp4", ",".join(wanted)), wanted)
        self.assertIn("this one of 33x17 has 34x18", run.err)
        film = self.bytes_of("film.mp4")
        self.assertLess(film.index(b"moov"), film.index(b"mdat"), "a player can begin before it has all")

    @unittest.skipUnless(HAVE_FFMPEG, "ffmpeg and ffprobe are not installed")
    def test_colours_are_those_of_the_stills(self):
        # All background, in a colour that BT.601 and BT.709 encode differently.
        colour = ("--camera-direction", "0,0,1", "--fov-degrees", 170, "--background", ".9,.1,.02", "--tone", "none",
                  "--size", "32x32")
        self.succeed("render", *MODEL, *colour, "--frames", "0:0", "-o", "film.mp4")
        self.succeed("render", *MODEL, *colour, "-o", "still.png")
        wanted = read_png(self.bytes_of("still.png")).at(1, 1)
        pixels = self.decoded("film.mp4", "-vf", "scale=in_color_matrix=bt709:in_range=tv:flags=accurate_rnd")
        at = 3 * (32 + 1)
        for got, channel in zip(pixels[at:at + 3], wanted):
            self.assertAlmostEqual(got, channel, delta=4)

    @unittest.skipUnless(HAVE_FFMPEG, "ffmpeg and ffprobe are not installed")
    def test_no_background_is_black(self):
        run = self.succeed("render", *MOVING, "--frames", "0:0", "-o", "film.mp4")
        self.assertIn("wrote 1 frame to film.mp4", run.err)
        self.assertLess(max(self.decoded("film.mp4")[:3]), 6)

    def test_without_ffmpeg_nothing_is_begun(self):
        nowhere = {**os.environ, "PATH": str(self.folder)}
        self.refused(1, "render", "no.ply", "--frames", "0:1", "-o", "film.mp4", env=nowhere,
                     says=("ffmpeg", "install", "frame_%04d.png"))
        self.assertEqual(self.listing(), [])

    def test_what_ffmpeg_complains_about_is_said(self):
        env = self.fake_ffmpeg("cat >/dev/null\necho first >&2\necho 'No space left on device' >&2\nexit 1\n")
        self.write("film.mp4", "old")
        self.refused(1, "render", *MOVING, "--frames", "0:3", "-o", "film.mp4", env=env,
                     says=("film.mp4", "No space left on device"))
        self.assertEqual((self.listing(), self.bytes_of("film.mp4")), (["film.mp4", "tools"], b"old"))

    def test_a_full_disk_is_the_reason_given(self):
        """Where ffmpeg gives it before its last line, which ends in two dashes and has none."""
        env = self.fake_ffmpeg("cat >/dev/null\necho 'Could not write header: No space left on device' >&2\n"
                               "echo 'Error initializing output stream 0:0 -- ' >&2\nexit 1\n")
        self.refused(1, "render", *MOVING, "--frames", "0:3", "-o", "film.mp4", env=env,
                     says=("film.mp4", "No space left on device"))

    def test_an_ffmpeg_that_leaves_early_is_an_error(self):
        env = self.fake_ffmpeg("echo 'Unknown encoder' >&2\nexit 1\n")
        self.refused(1, "render", *MODEL, *MOTION, "--size", "256x256", "--antialias", 1, "--frames", "0:9", "-o", "film.mp4", env=env,
                     says=("film.mp4", "Unknown encoder"))
        self.assertEqual(self.listing(), ["tools"])


class ProgressBar(Film):
    COLUMNS = 72

    def on_a_terminal(self, *arguments):
        """What a terminal receives on standard error."""
        try:
            terminal, side = pty.openpty()
        except OSError as error:
            self.skipTest(f"this machine has no terminals: {error}")
        fcntl.ioctl(side, termios.TIOCSWINSZ, struct.pack("4H", 25, self.COLUMNS, 0, 0))
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder, stderr=side)
        os.close(side)
        seen = b""
        while True:
            try:
                part = os.read(terminal, 4096)
            except OSError:  # what Linux says when nobody has it open any more
                break
            if not part:
                break
            seen += part
        os.close(terminal)
        self.assertEqual(process.wait(), 0, seen)
        return seen.decode()

    def test_is_drawn_and_erased(self):
        seen = self.on_a_terminal("render", *MOVING, "--frames", "0:9", "-o", "f%d.png")
        bars = re.findall(r"\r(frame \d+/10 \[[= ]*\][^\x1b]*)\x1b\[K", seen)
        self.assertTrue(bars, seen)
        for bar in bars:
            self.assertEqual(len(bar), self.COLUMNS - 1)
        self.assertRegex(bars[-1], r"frames/s, \d+:\d\d left$")
        end = seen[seen.rindex("\x1b[K"):]
        self.assertNotIn("frame ", end.replace("frames", ""))
        self.assertIn("wrote 10 frames", end)

    def test_quiet_shows_nothing(self):
        self.assertEqual(self.on_a_terminal("render", *MOVING, "--frames", "0:3", "-o", "f%d.png", "--quiet"), "")

    def test_a_file_gets_no_bar(self):
        self.assertNotIn("\r", self.succeed("render", *MOVING, "--frames", "0:3", "-o", "f%d.png").err)


if __name__ == "__main__":
    unittest.main()
