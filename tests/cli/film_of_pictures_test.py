"""`render --chunk` and `film`: a film shared by several programs."""

import json
import shutil
import struct
import subprocess
import unittest
import zlib

from program import ProgramTest

TEAPOT = ("--builtin", "teapot", "--shadow-size", 64, "--transport", "dipole", "--max-surfels", 1024, "--fov-degrees", 50,
          "--size", "24x16", "--deform", "wobble:0.1:0.7", "--fps", "12.5")
HAVE_FFMPEG = shutil.which("ffmpeg") and shutil.which("ffprobe")


def png(width, height, rgba):
    """A PNG of a single colour."""
    def part(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = (b"\0" + bytes(rgba) * width) * height
    return (b"\x89PNG\r\n\x1a\n" + part(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)) +
            part(b"IDAT", zlib.compress(rows)) + part(b"IEND", b""))


class Row(ProgramTest):
    def bytes_of(self, name):
        return (self.folder / name).read_bytes()

    def write_row(self, folder, numbers, colour=(200, 100, 50, 255), size=(32, 16)):
        (self.folder / folder).mkdir(exist_ok=True)
        for number in numbers:
            self.write(f"{folder}/f_{number:03}.png", png(*size, colour))


class Chunks(Row):
    def test_together_they_are_the_pictures_of_one_run(self):
        # The camera was not placed, so it must fit all frames, not only the chunk's.
        frames = ("--frames", "1:13:3")
        self.succeed("render", *TEAPOT, *frames, "-o", "whole_%02d.png")
        outputs = []
        for number, ends in ((1, [1, 1]), (2, [4, 7]), (3, [10, 13])):
            run = self.succeed("render", *TEAPOT, *frames, "--chunk", f"{number}/3", "-o", "part_%02d.png", "--json")
            self.assertEqual(run.json()["frames"], ends)
            outputs.append(run.json()["outputs"])
        self.assertEqual(outputs, [["part_01.png"], ["part_04.png", "part_07.png"], ["part_10.png", "part_13.png"]])
        for frame in range(1, 14, 3):
            self.assertEqual(self.bytes_of(f"part_{frame:02}.png"), self.bytes_of(f"whole_{frame:02}.png"), frame)

    def test_what_another_has_made_is_left(self):
        arguments = ("render", *TEAPOT, "--frames", "0:3", "--chunk", "2/2", "-o", "f%d.png", "--resume")
        self.succeed(*arguments)
        self.assertEqual(self.listing(), ["f2.png", "f3.png"])
        self.assertIn("2 of 2 frames existed already", self.succeed(*arguments).err)

    def test_more_chunks_than_frames(self):
        run = self.succeed("render", *TEAPOT, "--frames", "0:1", "--chunk", "1/3", "-o", "f%d.png", "--json")
        self.assertIn("chunk 1 of 3 has no frames", run.err)
        self.assertEqual((run.json()["frames"], run.json()["outputs"], self.listing()), (None, [], []))

    def test_refusals(self):
        row = ("render", "--frames", "0:9", "-o", "f%d.png", "--chunk")
        for text, says in (("0/4", "from 1 to 4"), ("5/4", "from 1 to 4"), ("3", "1/6"), ("1/2/3", "1/6"), ("a/2", "--chunk a")):
            self.refused(2, *row, text, says=("--chunk", says))
        self.refused(2, "render", "--chunk", "1/2", says="--frames A:B")
        self.refused(2, "render", "--frames", "0:9", "--chunk", "1/2", says="-o frame_%04d.png")
        self.refused(2, "render", "--frames", "0:9", "--chunk", "1/2", "-o", "a.mp4", says="opaline film")


class FilmOfPictures(Row):
    def probe(self, name):
        done = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v", "-show_entries",
                               "stream=width,height,nb_read_frames,r_frame_rate", "-of", "json", self.folder / name],
                              capture_output=True, check=True)
        return json.loads(done.stdout)["streams"][0]

    def first_pixel(self, name):
        return subprocess.run(["ffmpeg", "-v", "error", "-i", self.folder / name, "-f", "rawvideo", "-pix_fmt", "rgb24",
                               "-vf", "scale=in_color_matrix=bt709:in_range=tv:flags=accurate_rnd", "-"],
                              capture_output=True, check=True).stdout[:3]

    @unittest.skipUnless(HAVE_FFMPEG, "ffmpeg and ffprobe are not installed")
    def test_all_pictures_at_the_speed_they_were_rendered_for(self):
        self.succeed("render", *TEAPOT, "--frames", "2:6", "-o", "f_%04d.png")
        run = self.succeed("film", ".", "-o", "a.mp4", "--json")
        self.assertEqual(run.json(), {"frames": [2, 6], "frame_step": 1, "fps": 12.5, "outputs": ["a.mp4"]})
        self.assertEqual(self.probe("a.mp4"), {"width": 24, "height": 16, "r_frame_rate": "25/2", "nb_read_frames": "5"})
        run = self.succeed("film", "f_%04d.png", "-o", "b.mp4", "--frames", "2:6:2", "--fps", 24)
        self.assertNotIn("even", run.err)
        self.assertEqual((self.probe("b.mp4")["nb_read_frames"], self.probe("b.mp4")["r_frame_rate"]), ("3", "24/1"))

    @unittest.skipUnless(HAVE_FFMPEG, "ffmpeg and ffprobe are not installed")
    def test_an_odd_size_is_noted_once(self):
        self.write_row("shot", range(3), size=(31, 16))
        run = self.succeed("film", "shot", "-o", "a.mp4")
        self.assertEqual(run.err.count("this one of 31x16 has 32x16"), 1)
        self.assertEqual((self.probe("a.mp4")["width"], self.probe("a.mp4")["height"]), (32, 16))

    @unittest.skipUnless(HAVE_FFMPEG, "ffmpeg and ffprobe are not installed")
    def test_it_is_named_like_the_folder(self):
        self.write_row("shot", range(998, 1003))
        self.succeed("film", "shot")
        self.succeed("film", "shot/")
        self.assertEqual(self.listing(), ["shot", "shot-2.mp4", "shot.mp4"])
        self.assertEqual(self.probe("shot.mp4")["nb_read_frames"], "5")

    @unittest.skipUnless(HAVE_FFMPEG, "ffmpeg and ffprobe are not installed")
    def test_colours(self):
        self.write_row("shot", range(2))
        self.succeed("film", "shot", "-o", "a.mp4")
        self.write_row("clear", range(2), (200, 100, 50, 0))
        self.succeed("film", "clear", "-o", "b.mp4")
        self.succeed("film", "clear", "-o", "c.mp4", "--background", "1,0,0")
        for name, wanted in (("a.mp4", (200, 100, 50)), ("b.mp4", (0, 0, 0)), ("c.mp4", (255, 0, 0))):
            for got, channel in zip(self.first_pixel(name), wanted):
                self.assertAlmostEqual(got, channel, delta=5, msg=name)

    @unittest.skipUnless(HAVE_FFMPEG, "ffmpeg and ffprobe are not installed")
    def test_of_linear_pictures_it_is_the_film_that_render_makes(self):
        self.succeed("render", *TEAPOT, "--frames", "0:1", "-o", "f%d.exr")
        self.succeed("render", *TEAPOT, "--frames", "0:1", "--exposure", 2, "-o", "wanted.mp4")
        self.succeed("film", ".", "--exposure", 2, "-o", "got.mp4")
        self.assertEqual(self.bytes_of("got.mp4"), self.bytes_of("wanted.mp4"))

    def test_what_is_missing_or_broken_is_counted_and_nothing_is_written(self):
        self.write_row("shot", (0, 1, 3, 6, 7))
        self.write("shot/f_003.png", self.bytes_of("shot/f_001.png")[:-3])
        self.write("shot/f_007.png", png(16, 16, (1, 2, 3, 4)))
        before = self.listing()
        for options in (("--check",), ("-o", "a.mp4")):
            self.refused(1, "film", "shot", *options,
                         says=("3 of 8 frames are missing (2, 4 to 5) and 2 are damaged or not 32x16 (3, 7); "
                               "render --resume makes them"))
        self.refused(1, "film", "shot", "--check", "--frames", "0:9", says="5 of 10 frames are missing (2, 4 to 5, 8 to 9)")
        self.assertEqual(self.listing(), before)

    def test_frames_with_a_step_need_not_be_missing(self):
        self.write_row("shot", (0, 2, 4))
        self.refused(1, "film", "shot", "--check",
                     says=("2 of 5 frames are missing (1, 3)", "--frames 0:4:2", "render --resume --frames 0:4 "))
        self.succeed("film", "shot", "--check", "--frames", "0:4:2")
        self.write_row("holes", (0, 1, 3))
        run = self.refused(1, "film", "holes", "--check", says="1 of 4 frames is missing (2); render --resume makes them")
        self.assertNotIn("--frames", run.err)

    def test_damage_in_the_middle_is_seen_too(self):
        self.write_row("shot", range(3))
        whole = bytearray(self.bytes_of("shot/f_001.png"))
        at = whole.index(b"IDAT") + 6
        whole[at:at + 12] = bytes(12)
        self.write("shot/f_001.png", bytes(whole))
        for options in (("--check",), ("-o", "a.mp4")):
            self.refused(1, "film", "shot", *options, says="f_001.png")
        self.assertEqual(self.listing(), ["shot"])

    def test_pictures_of_another_scene_are_noted(self):
        self.succeed("render", *TEAPOT, "--frames", "0:3", "-o", "f%d.png")
        self.assertEqual(self.succeed("film", ".", "--check").err, "note: all 4 frames are whole.\n")
        self.succeed("render", *TEAPOT, "--medium", "jade", "--frames", "2:2", "-o", "f%d.png")
        self.assertIn("1 of 4 pictures, ./f2.png among them", self.succeed("film", ".", "--check").err)

    def test_pictures_with_another_camera_light_motion_or_rate_are_noted(self):
        def render(frames, *others, **changed):
            options = {"--camera-position": "0,0,200", "--fps": "12.5", "--deform": "wobble:0.1:0.7"} | changed
            self.succeed("render", *TEAPOT[:TEAPOT.index("--deform")], *(part for pair in options.items() for part in pair),
                         "--frames", frames, "-o", "f%d.png", *others)
        render("0:3")
        self.assertEqual(self.succeed("film", ".", "--check").err, "note: all 4 frames are whole.\n")
        for other in ({"--camera-position": "0,9,200"}, {"--ambient": "1,0,0"}, {"--deform": "wobble:0.2:0.7"},
                      {"--fps": 24}, {"--exposure": 1}):
            render("2:2", **other)
            self.assertIn("1 of 4 pictures, ./f2.png among them", self.succeed("film", ".", "--check").err, other)
            # As the note says.
            render("0:3", "--resume")
            self.assertEqual(self.succeed("film", ".", "--check").err, "note: all 4 frames are whole.\n", other)

    def test_refusals(self):
        (self.folder / "empty").mkdir()
        self.write_row("two", range(2))
        self.write("two/g1.png", b"")
        self.refused(1, "film", "empty", "--check", says=("empty", "no numbered pictures"))
        self.refused(1, "film", "none", "--check", says="none")
        self.refused(1, "film", "two/h_%d.png", "--check", says="h_%d.png")
        self.refused(2, "film", "two", "--check", says=("f_%03d.png", "g%d.png"))
        self.refused(2, "film", says="DIR is missing")
        self.refused(2, "film", "two/f_%03d.png", "--check", "-o", "a.mp4", says="--check")
        self.refused(2, "film", "two/f_%03d.jpg", "--check", says=".png or .exr")
        self.refused(2, "film", "two/f_%03d.png", "-o", "a.mp4", "--exposure", 1, says="--exposure")
        self.refused(2, "film", "two/f_%03d.png", "-o", "a.mp4", "--background", "environment", says="--background")
        self.refused(2, "film", "two/f_%03d.png", "-o", "a.png", says=".mp4")


if __name__ == "__main__":
    unittest.main()
