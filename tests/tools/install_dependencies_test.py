"""What scripts/install-dependencies.sh asks the package manager for, with stand-ins for it."""

import os
import pathlib
import stat
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "install-dependencies.sh"

# Like the real one: prints what it knows, fails when it has never heard of some package.
DPKG_QUERY = """#!/bin/sh
shift 2
status=0
for package in "$@"; do
  case " $INSTALLED " in
    *" $package "*) echo "ii $package" ;;
    *) echo "dpkg-query: no packages found matching $package" >&2; status=1 ;;
  esac
done
exit $status
"""
APT_GET = """#!/bin/sh
echo "$@" >> "$APT_LOG"
"""
NOTHING = "#!/bin/sh\nexit 0\n"
AS_USER = '#!/bin/sh\nexec "$@"\n'


class InstallDependencies(unittest.TestCase):
    def asked_for(self, installed, *words):
        with tempfile.TemporaryDirectory() as folder:
            stubs = {"dpkg-query": DPKG_QUERY, "apt-get": APT_GET, "apt-cache": NOTHING,
                     "clang-format-14": NOTHING, "clang-tidy-14": NOTHING, "sudo": AS_USER}
            for name, text in stubs.items():
                path = pathlib.Path(folder, name)
                path.write_text(text)
                path.chmod(path.stat().st_mode | stat.S_IXUSR)
            log = pathlib.Path(folder, "log")
            log.touch()
            environment = dict(os.environ, PATH=f"{folder}:{os.environ['PATH']}",
                               INSTALLED=" ".join(installed), APT_LOG=str(log))
            subprocess.run([SCRIPT, *words], check=True, env=environment, stderr=subprocess.PIPE)
            lines = [line.split() for line in log.read_text().splitlines()]
        return {word for line in lines if line[0] == "install" for word in line[1:]
                if not word.startswith("-")}

    def of_library(self):
        return SCRIPT.read_text().split("apt_library=(")[1].split(")")[0].split()

    def wanted(self):
        rest = SCRIPT.read_text().split("\napt_packages=(")[1].split(")")[0].split()
        return self.of_library() + rest[1:]  # the first word stands for the library's

    def test_a_machine_that_has_none_of_them_gets_all(self):
        self.assertEqual(self.asked_for([]), set(self.wanted()))

    def test_a_machine_that_lacks_one_gets_that_one(self):
        self.assertEqual(self.asked_for([p for p in self.wanted() if p != "glslc"]), {"glslc"})

    def test_a_machine_that_has_all_is_left_alone(self):
        self.assertEqual(self.asked_for(self.wanted()), set())

    def test_the_library_alone_needs_less(self):
        asked = self.asked_for([], "--library")
        self.assertEqual(asked, set(self.of_library()))
        for package in ("libglfw3-dev", "libimgui-dev", "libembree-dev", "libtbb-dev", "libcli11-dev", "libgtest-dev", "xvfb", "ffmpeg"):
            self.assertNotIn(package, asked)
            self.assertIn(package, self.wanted())


if __name__ == "__main__":
    unittest.main()
