"""Doxygen reads the public headers without a complaint, and finds a comment at every function."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import shared_comments


def described(member):
    return any("".join(member.find(kind).itertext()).strip() for kind in ("briefdescription", "detaileddescription"))


class Doxygen(unittest.TestCase):
    def test_a_comment_above_a_group_is_that_of_each(self):
        self.assertEqual(shared_comments.shared("#pragma once\n\n/// Both.\nint one();\nint two();\n\nint bare();\nint own();  ///< Its own.\n"),
                         "/// @file\n#pragma once\n\n/// Both.\nint one();\n/// Both.\nint two();\n\nint bare();\n"
                         "int own();  ///< Its own.\n")
        within = "/// Outer.\nstruct Outer {\n  int member;\n};\n"
        self.assertEqual(shared_comments.shared(within), "/// @file\n" + within)

    @unittest.skipUnless(shutil.which("doxygen"), "Doxygen is not there")
    def test_it_reads_the_headers(self):
        with tempfile.TemporaryDirectory() as folder:
            settings = (ROOT / "docs" / "Doxyfile").read_text() + f"OUTPUT_DIRECTORY = {folder}\nGENERATE_HTML = NO\nGENERATE_XML = YES\n"
            done = subprocess.run(["doxygen", "-"], input=settings, cwd=ROOT, capture_output=True, text=True, check=True)
            self.assertEqual(done.stderr, "")
            functions = {}
            for file in pathlib.Path(folder, "xml").glob("*.xml"):
                for member in xml.etree.ElementTree.parse(file).iter("memberdef"):
                    if member.get("kind") == "function":
                        functions.setdefault(member.findtext("name"), []).append(described(member))
        headers = "".join(path.read_text() for path in (ROOT / "include" / "opaline" / "c").glob("*.h"))
        in_c = set(re.findall(r"\b(opaline\w+)\(", re.sub(r"//[^\n]*", "", headers)))
        self.assertGreater(len(in_c), 90)
        self.assertEqual({name for name in in_c if not any(functions.get(name, []))}, set())
        for name in ("loadScene", "record", "collect", "setMedium", "firstNumber", "vulkanNeeds"):
            self.assertTrue(all(functions[name]), name)


if __name__ == "__main__":
    unittest.main()
