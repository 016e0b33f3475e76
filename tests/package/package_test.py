"""What `cmake --install` leaves behind is all that another project needs, in a folder that knows nothing of ours.

BUILD names the build folder, which is whole. `make package-check` runs this on a shared library."""

import os
import pathlib
import re
import shutil
import tempfile
import unittest

from installed import BUILD, CMAKE, ROOT, Installed, cached, run

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


class Package(Installed):
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

    def run_python(self, *words, folder=None):
        """With the module that is installed; says where it was if it crashes."""
        if cached("OPALINE_BUILD_PYTHON") != "ON":
            self.skipTest("this build has no Python module")
        site, = (self.prefix / "lib").glob("python3*/site-packages")
        return run(cached("OPALINE_PYTHON_EXECUTABLE"), "-X", "faulthandler", *words, cwd=folder, env=os.environ | {"PYTHONPATH": str(site)})

    def test_the_python_module_is_found_there(self):
        done = self.run_python("-c", "import opaline; print(opaline.teapot().objects[0])")
        self.assertIn("2256 triangles", done.stdout, done.stderr)

    def test_the_examples_in_python(self):
        for name, needed, pictures in (("sweep.py", "matplotlib", {"sweep.png", "exitance.png"}), ("fit.py", "scipy", {"fit.png"})):
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                if self.run_python("-c", f"import {needed}").returncode != 0:
                    self.skipTest(f"{name} needs {needed}")
                shutil.copy(ROOT / "examples" / "python" / name, folder)
                done = self.run_python(name, "--quick", folder=folder)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertEqual({path.name for path in pathlib.Path(folder).iterdir()}, {name} | pictures)

    def test_another_project_finds_it(self):
        folder = self.project("found")
        self.succeed(CMAKE, "-G", "Ninja", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        self.succeed(CMAKE, "--build", folder / "build")
        self.assert_draws(folder / "build" / "picture")

    def test_the_page_of_the_library_is_right(self):
        page = (ROOT / "docs" / "library.md").read_text()
        lists, program = (re.search(rf"```{language}\n(.*?)```", page, re.DOTALL)[1] for language in ("cmake", "cpp"))
        commands = re.search(r"```\n(cmake -G Ninja .*?)```", page, re.DOTALL)[1]
        folder = self.folder / "page"
        folder.mkdir()
        (folder / "CMakeLists.txt").write_text(lists)
        (folder / "your_program.cpp").write_text("#include <opaline/opaline.h>\nint main() {\n" + program + "}\n")
        (folder / "bunny.ply").write_text("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                                          "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
                                          "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
        (self.folder / "opaline").symlink_to(self.prefix)
        self.succeed("sh", "-e", "-c", commands, cwd=folder, env=os.environ | {"HOME": str(self.folder)})
        self.succeed(folder / "build" / "your_program", cwd=folder,
                     env=os.environ | {"LD_LIBRARY_PATH": str(self.prefix / "lib")})
        self.assertTrue((folder / "bunny.png").is_file())

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
            self.assertIn(f"{frames} frames", self.run_example(program, frames, picture))
        self.assertNotEqual(*(picture.read_bytes() for picture in pictures))

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
