"""Every picture of docs/ has a command, and where it is one of the program the page shows it."""

import pathlib
import shlex
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tests" / "cli")]

import documents
import make_pictures


class Manifest(unittest.TestCase):
    def test_each_picture_is_made_once(self):
        made = [picture for _, entry in make_pictures.entries() for picture in entry["pictures"]]
        self.assertEqual(len(made), len(set(made)))
        self.assertEqual(set(made) & make_pictures.by_hand(), set())
        self.assertEqual(set(made) | make_pictures.by_hand(), {path.name for path in make_pictures.IMAGES.iterdir()})

    def test_its_page_shows_the_command(self):
        pages = documents.pages()
        for page, entry in make_pictures.entries():
            for picture in entry["pictures"]:
                self.assertTrue(any(f"images/{picture}" in text for text in pages.values()), picture)
            if "beside" in entry:
                continue
            shown = documents.commands(pages[page])
            for command in entry["commands"]:
                words = shlex.split(command)
                if words[0] == "opaline":
                    # What the page leaves away is where a plot goes.
                    self.assertTrue(any(words in (line, [*line, *words[-2:]]) for line in shown), (page, command))

    def test_commands_run_with_programs_and_models_in_their_places(self):
        with tempfile.TemporaryDirectory() as folder:
            models = pathlib.Path(folder)
            (models / "a.ply").touch()
            programs = {"opaline": "/bin/opaline", "opaline_figures": "/bin/figures"}
            self.assertEqual(make_pictures.words_of("opaline info a.ply b.ply", programs, models),
                             ["/bin/opaline", "info", str(models / "a.ply"), "b.ply"])
            self.assertEqual(make_pictures.words_of("opaline_figures walk", programs, models),
                             ["/bin/figures", "walk", "--into", "."])


if __name__ == "__main__":
    unittest.main()
