"""What clang-tidy has found clean stays so in another checkout, until something of it changes."""

import pathlib
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))

import check_tidy


class Fingerprint(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def of(self, checkout, header, option=""):
        """Of a file of a unity build, where the compiler finds its header."""
        root = self.folder / checkout
        root.mkdir(exist_ok=True)
        unit = root / "unit.cxx"
        unit.write_text(f'#include "{root}/a.cpp"\n')
        (root / "a.h").write_text(header)
        with mock.patch.object(check_tidy, "ROOT", root):
            return check_tidy.fingerprint(b"", f"c++ -I{root} {option} {unit}", [unit, root / "a.h"])

    def test_is_the_same_in_another_checkout(self):
        self.assertEqual(self.of("one", "int a;"), self.of("two", "int a;"))

    def test_follows_headers_and_options(self):
        before = self.of("one", "int a;")
        self.assertNotEqual(before, self.of("one", "int b;"))
        self.assertNotEqual(before, self.of("one", "int a;", "-DNDEBUG"))


if __name__ == "__main__":
    unittest.main()
