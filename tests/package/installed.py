"""What tests need that use the installed package: BUILD names the build folder, which is whole."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("BUILD", ROOT / "build" / "release"))
CMAKE = os.environ.get("CMAKE", "cmake")


def run(*words, **more):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **more)


def cached(name):
    """What CMake's cache of the build says."""
    for line in (BUILD / "CMakeCache.txt").read_text().splitlines():
        if line.startswith(name + ":"):
            return line.partition("=")[2]
    return ""


class Installed(unittest.TestCase):
    """Installs it once for all tests, into an empty folder that is there until they end."""

    temporary = None

    @classmethod
    def setUpClass(cls):
        if Installed.temporary:
            return
        Installed.temporary = tempfile.TemporaryDirectory()
        Installed.folder = pathlib.Path(cls.temporary.name)
        Installed.prefix = cls.folder / "prefix"
        done = run(CMAKE, "--install", BUILD, "--prefix", cls.prefix)
        assert done.returncode == 0, done.stderr
        Installed.shared = cached("BUILD_SHARED_LIBS") in ("ON", "TRUE", "1")

    def succeed(self, *words, **more):
        done = run(*words, **more)
        self.assertEqual(done.returncode, 0, f"{words}: {done.stdout}{done.stderr}")
        return done.stdout

    def built_examples(self, language):
        """The folder with the programs of examples/LANGUAGE, copied elsewhere and built there."""
        return self.built(ROOT / "examples" / language)

    def built(self, project):
        """The same of any project's folder."""
        folder = self.folder / f"{project.parent.name}_{project.name}"
        if not folder.exists():
            shutil.copytree(project, folder)
            self.succeed(CMAKE, "-G", "Ninja", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}")
            self.succeed(CMAKE, "--build", folder / "build")
        return folder / "build"

    def run_example(self, program, *words):
        return self.succeed(program, *words, cwd=program.parent,
                            env=os.environ | {"LD_LIBRARY_PATH": str(self.prefix / "lib")})
