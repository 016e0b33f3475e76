"""What `cmake --install` leaves behind is all that another project needs, in a folder that knows nothing of ours.

BUILD names the build folder, which is whole. `make package-check` runs this on a shared library."""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("BUILD", ROOT / "build" / "release"))
CMAKE = os.environ.get("CMAKE", "cmake")

PROJECT = """cmake_minimum_required(VERSION 3.24)
project(picture LANGUAGES CXX)
find_package(Opaline 0.2 REQUIRED)
add_executable(picture picture.cpp)
target_link_libraries(picture PRIVATE opaline::opaline)
"""

PROGRAM = """#include <opaline/opaline.h>

#include <cstdio>

int main() try {
  static_assert(OPALINE_VERSION_MAJOR == 0 && OPALINE_VERSION_MINOR >= 2 && OPALINE_VERSION_PATCH >= 0);
  opaline::Renderer renderer;
  renderer.setScene(opaline::builtInTeapot());
  opaline::RenderOptions options;
  options.width = 32;
  options.height = 24;
  options.transport = opaline::Transport::Dipole;
  const opaline::RenderResult result = renderer.render(options);
  std::printf("%dx%d\\n", result.images[0].width, result.images[0].height);
  renderer.setScene({});
} catch (const opaline::Error& error) {
  std::printf("refused: %s\\n", error.what());
}
"""


def run(*words, **more):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **more)


def cached(name):
    """What CMake's cache of the build says."""
    for line in (BUILD / "CMakeCache.txt").read_text().splitlines():
        if line.startswith(name + ":"):
            return line.partition("=")[2]
    return ""


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        cls.prefix = cls.folder / "prefix"
        done = run(CMAKE, "--install", BUILD, "--prefix", cls.prefix)
        assert done.returncode == 0, done.stderr
        cls.shared = cached("BUILD_SHARED_LIBS") in ("ON", "TRUE", "1")

    def succeed(self, *words, **more):
        done = run(*words, **more)
        self.assertEqual(done.returncode, 0, f"{words}: {done.stdout}{done.stderr}")
        return done.stdout

    def project(self, name):
        folder = self.folder / name
        folder.mkdir()
        (folder / "CMakeLists.txt").write_text(PROJECT)
        (folder / "picture.cpp").write_text(PROGRAM)
        return folder

    def assert_draws(self, program):
        lines = self.succeed(program, env=os.environ | {"LD_LIBRARY_PATH": str(self.prefix / "lib")}).splitlines()
        self.assertEqual(lines[0], "32x24")
        self.assertTrue(lines[1].startswith("refused: "), lines)

    def test_nothing_installed_names_our_folders(self):
        names = [str(path).encode() for path in (ROOT, BUILD.resolve())]
        files = [path for path in self.prefix.rglob("*") if path.is_file()]
        self.assertGreater(len(files), 40)
        for path in files:
            content = path.read_bytes()
            for name in names:
                self.assertNotIn(name, content, path)

    def test_licence_pages_and_headers_are_there(self):
        documents = self.prefix / "share" / "doc" / "opaline"
        for path in (documents / "LICENSE", documents / "docs" / "media.md", self.prefix / "include" / "opaline" / "version.h",
                     self.prefix / "lib" / "cmake" / "Opaline" / "OpalineConfig.cmake"):
            self.assertTrue(path.is_file(), path)
        ours, installed = ({str(path.relative_to(folder)) for path in (folder / "include").rglob("*.h")}
                           for folder in (ROOT, self.prefix))
        self.assertEqual(installed, ours | {"include/opaline/version.h"})

    def test_the_program_runs_from_there(self):
        program = self.prefix / "bin" / "opaline"
        if cached("OPALINE_BUILD_PROGRAM") != "ON":
            self.skipTest("this build has no program")
        self.assertTrue(self.succeed(program, "--version").startswith("opaline 0."))

    def test_the_python_module_is_found_there(self):
        python = cached("OPALINE_PYTHON_EXECUTABLE")
        if cached("OPALINE_BUILD_PYTHON") != "ON":
            self.skipTest("this build has no Python module")
        site, = (self.prefix / "lib").glob("python3*/site-packages")
        code = "import opaline; print(opaline.teapot().objects[0])"
        self.assertIn("2256 triangles", self.succeed(python, "-c", code, env=os.environ | {"PYTHONPATH": str(site)}))

    def test_another_project_finds_it(self):
        folder = self.project("found")
        self.succeed(CMAKE, "-G", "Ninja", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        self.succeed(CMAKE, "--build", folder / "build")
        self.assert_draws(folder / "build" / "picture")

    def test_it_moves_as_a_whole(self):
        moved = self.folder / "moved"
        shutil.copytree(self.prefix / "include", moved / "include")
        shutil.copytree(self.prefix / "lib", moved / "lib", symlinks=True)
        folder = self.project("of_the_moved")
        self.succeed(CMAKE, "-G", "Ninja", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={moved}")

    def test_another_minor_version_is_refused(self):
        folder = self.project("refused")
        (folder / "CMakeLists.txt").write_text(PROJECT.replace("0.2", "0.99"))
        done = run(CMAKE, "-G", "Ninja", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("Opaline", done.stderr)

    def built_examples(self, language):
        """The folder with the programs of examples/LANGUAGE, copied elsewhere and built there."""
        folder = self.folder / f"examples_{language}"
        if not folder.exists():
            shutil.copytree(ROOT / "examples" / language, folder)
            self.succeed(CMAKE, "-G", "Ninja", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}")
            self.succeed(CMAKE, "--build", folder / "build")
        return folder / "build"

    def run_example(self, program, *words):
        return self.succeed(program, *words, cwd=program.parent,
                            env=os.environ | {"LD_LIBRARY_PATH": str(self.prefix / "lib")})

    def test_meshes_of_examples_move(self):
        for language in ("cpp", "c"):
            program = self.built_examples(language) / "moving_mesh"
            first, later = (program.parent / f"{frames}.png" for frames in (1, 4))
            self.assertIn("1 frames", self.run_example(program, 1, first))
            self.assertIn("4 frames", self.run_example(program, 4, later))
            self.assertNotEqual(first.read_bytes(), later.read_bytes())

    def test_the_engine_draws_a_body_over_its_floor(self):
        program = self.built_examples("vulkan") / "engine"
        pictures = [program.parent / f"{frames}.png" for frames in (1, 4)]
        for frames, picture in zip((1, 4), pictures):
            said = self.run_example(program, frames, picture, "--validate")  # fails if the layer says anything
            self.assertIn(f"{frames} frames", said)
        self.assertNotEqual(*(picture.read_bytes() for picture in pictures))

    def test_the_same_picture_in_every_language(self):
        pictures = {}
        for language in ("cpp", "c"):
            program = self.built_examples(language) / "still"
            files = [program.parent / name for name in ("still.png", "radiance.exr", "exitance.exr")]
            self.assertIn("exitance in the middle", self.run_example(program, *files))
            pictures[language] = [path.read_bytes() for path in files]
        self.assertEqual(pictures["cpp"], pictures["c"])
        program = self.prefix / "bin" / "opaline"
        if not program.exists():
            return
        ours = self.folder / "radiance.exr"
        self.succeed(program, "render", "--medium", "jade", "--size", "320x320", "--directional", "0.6,0,-0.8:6,6,5",
                     "--directional", "0,1,0:0.5,0.5,0.6", "--ambient", "0.05,0.05,0.05", "--aov", "radiance", "-o", ours)
        theirs = self.built_examples("cpp") / "radiance.exr"
        self.assertEqual(json.loads(self.succeed(program, "compare", ours, theirs, "--json"))["max_abs"], 0)

    @unittest.skipUnless(shutil.which("pkg-config"), "pkg-config is not there")
    def test_pkg_config_knows_it(self):
        folder = self.project("by_pkg_config")
        environment = os.environ | {"PKG_CONFIG_PATH": str(self.prefix / "lib" / "pkgconfig")}
        kind = [] if self.shared else ["--static"]
        flags = self.succeed("pkg-config", "--cflags", "--libs", *kind, "opaline", env=environment).split()
        self.succeed(os.environ.get("CXX", "c++"), "-std=c++20", "-o", folder / "picture", folder / "picture.cpp", *flags)
        self.assert_draws(folder / "picture")

    def test_a_shared_library_shows_its_interface_alone(self):
        if not self.shared:
            self.skipTest("this build makes a static library")
        library = self.prefix / "lib" / "libopaline.so"
        version = cached("CMAKE_PROJECT_VERSION")
        self.assertIn(f"[libopaline.so.{version.rpartition('.')[0]}]", self.succeed("readelf", "-d", library))
        symbols = [line.split(" ", 2)[-1] for line in
                   self.succeed("nm", "-DC", "--defined-only", "--no-weak", library).splitlines()]
        ours = [name for name in symbols if "opaline::" in name]
        self.assertGreater(len(ours), 50)
        folders = {path.name for path in (ROOT / "src").iterdir() if path.is_dir()} - {"options", "compare"}  # public
        for folder in folders:
            self.assertEqual([name for name in ours if f" opaline::{folder}::" in f" {name}"], [])


if __name__ == "__main__":
    unittest.main()
