"""The library is built, and taken into another project, without the packages of program, viewer, reference,
benchmarks and tests; whoever links it sees its public headers and no others."""

import json
import os
import pathlib
import re
import shlex
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CMAKE = os.environ.get("CMAKE", "cmake")
# What only the rest needs.
NOT_THERE = ("CLI11", "glfw3", "Fontconfig", "embree", "TBB", "GTest")

PROJECT = """cmake_minimum_required(VERSION 3.24)
project(picture LANGUAGES CXX)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
add_subdirectory({root} opaline)
add_executable(picture picture.cpp)
target_link_libraries(picture PRIVATE opaline::opaline)
"""

PROGRAM = """#include <opaline/exposure.h>
#include <opaline/renderer.h>
#include <opaline/scene.h>

int main() {
  opaline::Renderer renderer;
  renderer.setScene(opaline::builtInBear({}));
  renderer.render({});
}
"""


def run(*words):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)


def configure(*words):
    absent = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in NOT_THERE]
    return run(CMAKE, "-G", "Ninja", *words, *absent)


class Library(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def succeed(self, done):
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def compile(self, text):
        """Whether the other project's file may say that."""
        (self.folder / "picture.cpp").write_text(text)
        command, = (entry for entry in json.loads((self.folder / "build" / "compile_commands.json").read_text())
                    if entry["file"] == str(self.folder / "picture.cpp"))
        return run(*shlex.split(command["command"]), "-fsyntax-only")

    def test_the_preset_needs_no_package_of_the_rest(self):
        self.succeed(configure("--preset", "library", "-S", ROOT, "-B", self.folder))
        commands = json.loads((self.folder / "compile_commands.json").read_text())
        ours = {pathlib.Path(entry["file"]).relative_to(ROOT).parts[0] for entry in commands
                if pathlib.Path(entry["file"]).is_relative_to(ROOT)}
        self.assertEqual(ours, {"src"})

    def test_another_project_takes_it_in(self):
        (self.folder / "CMakeLists.txt").write_text(PROJECT.format(root=ROOT))
        (self.folder / "picture.cpp").write_text(PROGRAM)
        self.succeed(configure("-S", self.folder, "-B", self.folder / "build"))
        self.assertIn("picture", self.succeed(run("ninja", "-C", self.folder / "build", "-n", "picture")))
        self.succeed(self.compile(PROGRAM))
        for hidden in ("core/digest.h", "renderer/validate.h", "gpu/device.h"):
            self.assertNotEqual(self.compile(f"#include <{hidden}>\n").returncode, 0, hidden)

    def test_what_needs_more_says_so(self):
        done = configure("--preset", "library", "-S", ROOT, "-B", self.folder, "-DOPALINE_BUILD_PROGRAM=ON")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("OPALINE_BUILD_PROGRAM is on, which needs OPALINE_BUILD_REFERENCE", " ".join(done.stderr.split()))


class Headers(unittest.TestCase):
    FOLDER = ROOT / "include" / "opaline"
    PUBLIC = sorted(FOLDER.rglob("*.h"))

    def names(self):
        return {str(path.relative_to(self.FOLDER)) for path in self.PUBLIC}

    def test_one_header_includes_all(self):
        included = re.findall(r'#include "opaline/(.*)"', (ROOT / "include" / "opaline" / "opaline.h").read_text())
        self.assertEqual(included, sorted({name for name in self.names() if not name.startswith("c/")} - {"opaline.h", "opaline_c.h"} | {"version.h"}))
        included = re.findall(r'#include "opaline/(.*)"', (ROOT / "include" / "opaline" / "opaline_c.h").read_text())
        self.assertEqual(included, sorted(name for name in self.names() if name.startswith("c/")))

    def test_every_function_and_class_is_exported(self):
        for path in self.PUBLIC:
            text = re.sub(r"^template <[^>].*\n(\[\[.*)?.*", "", path.read_text(), flags=re.MULTILINE)
            functions = re.findall(r"^(?!inline |template <>|constexpr |using |typedef |static_assert|#|//|OPALINE_API )[\w:].*\(", text,
                                   re.MULTILINE)
            classes = re.findall(r"^class (?!OPALINE_API )\w+ .*", text, re.MULTILINE)
            self.assertEqual(functions + classes, [], path.name)


class Lists(unittest.TestCase):
    def test_no_list_takes_itself_for_the_whole(self):
        files = [path for path in ROOT.glob("**/CMakeLists.txt") if "build" not in path.relative_to(ROOT).parts]
        self.assertGreater(len(files), 20)
        for path in files + list((ROOT / "cmake").glob("*.cmake")):
            for name in ("CMAKE_SOURCE_DIR", "CMAKE_BINARY_DIR"):
                self.assertNotIn("{" + name + "}", path.read_text(), path)


if __name__ == "__main__":
    unittest.main()
