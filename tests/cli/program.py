"""Runs the program and checks what every run must do: return a status, and print at most one sentence of error."""

import json
import os
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

PROGRAM = pathlib.Path(os.environ["OPALINE"]).resolve()
COMMANDS = ("render", "film", "view", "reference", "compare", "bench", "info", "media", "profile")

LONGEST_SECONDS = 300

# With a normal for every face, so that its sides are flat.
CUBE_OBJ = """v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1
vn 0 0 -1\nvn 0 0 1\nvn 0 -1 0\nvn 1 0 0\nvn 0 1 0\nvn -1 0 0
f 4//1 3//1 2//1 1//1\nf 5//2 6//2 7//2 8//2\nf 1//3 2//3 6//3 5//3
f 2//4 3//4 7//4 6//4\nf 3//5 4//5 8//5 7//5\nf 4//6 1//6 5//6 8//6
"""


def heed_signals(ignored):
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN if number in ignored else signal.SIG_DFL)
    signal.pthread_sigmask(signal.SIG_SETMASK, ())


class Run:
    def __init__(self, arguments, folder, **keywords):
        keywords.setdefault("stdout", subprocess.PIPE)
        keywords.setdefault("stderr", subprocess.PIPE)
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=folder, timeout=LONGEST_SECONDS, **keywords)
        self.arguments = arguments
        self.status = done.returncode
        self.out = (done.stdout or b"").decode()
        self.err = (done.stderr or b"").decode()

    def json(self):
        return json.loads(self.out)


class ProgramTest(unittest.TestCase):
    """Each test has its own empty folder, in which the program runs."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def run_program(self, *arguments, **keywords):
        return Run(arguments, self.folder, **keywords)

    def succeed(self, *arguments, **keywords):
        run = self.run_program(*arguments, **keywords)
        self.assertEqual(run.status, 0, f"{arguments}: {run.err}")
        return run

    def refused(self, status, *arguments, says=(), **keywords):
        """Expects failure with this status and one sentence that contains all of `says`, and no other output."""
        run = self.run_program(*arguments, **keywords)
        self.assertEqual(run.status, status, f"{arguments}: {run.out[:200]} {run.err}")
        errors = [line for line in run.err.splitlines() if not line.startswith(("note: ", "warning: "))]
        self.assertEqual(len(errors), 1, run.err)
        self.assertTrue(errors[0].startswith("opaline: "), run.err)
        self.assertEqual(run.out, "", arguments)
        for part in (says,) if isinstance(says, str) else says:
            self.assertIn(part, errors[0])
        return run

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def start(self, *arguments, ignored=(), **keywords):
        """Starts the program without waiting; it is killed at the end of the test if still running. Signals that are
        not ignored end it, whatever the caller of the tests does with signals."""
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder,
                                   preexec_fn=lambda: heed_signals(ignored), **keywords)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def wait_for(self, what, process):
        """Waits until `what` holds, which must be before the process ends."""
        deadline = time.monotonic() + LONGEST_SECONDS
        while not what():
            self.assertIsNone(process.poll(), "it ended too early")
            self.assertLess(time.monotonic(), deadline)
            time.sleep(.01)

    def listing(self):
        return sorted(path.name for path in self.folder.iterdir())
