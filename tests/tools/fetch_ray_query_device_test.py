"""What scripts/fetch-ray-query-device.sh does where there is nothing to be fetched, with stand-ins for apt."""

import os
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "fetch-ray-query-device.sh"

FAILS = "#!/bin/sh\nexit 1\n"
# Knows an archive for every code name, and no package.
EMPTY = """#!/bin/sh
[ "$1" = indextargets ] || exit 1
. /etc/os-release
echo "$VERSION_CODENAME file:/nowhere"
"""


class FetchRayQueryDevice(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def run_with(self, apt_get):
        tools = self.folder / "tools"
        tools.mkdir(exist_ok=True)
        for name, text in (("apt-get", apt_get), ("dpkg-deb", FAILS)):
            (tools / name).write_text(text)
            (tools / name).chmod(0o755)
        return subprocess.run([SCRIPT, self.folder / "device"], capture_output=True, text=True, check=True,
                              env={**os.environ, "PATH": f"{tools}:{os.environ['PATH']}"}).stderr

    def test_what_cannot_be_had_is_left_out(self):
        for apt_get in (FAILS, EMPTY):
            said = self.run_with(apt_get)
            self.assertRegex(said, r"^fetch-ray-query-device: .*; tests of ray queries on it are left out\n$")
            self.assertFalse((self.folder / "device").exists())

    def test_what_is_there_stays(self):
        device = self.folder / "device" / "device.json"
        device.parent.mkdir()
        device.write_text("as it was")
        self.assertEqual(self.run_with(FAILS), "")
        self.assertEqual(device.read_text(), "as it was")


if __name__ == "__main__":
    unittest.main()
