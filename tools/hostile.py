#!/usr/bin/env python3
"""Feeds hostile files to the program: `info`, a picture, and a picture by the paper's method, which makes an atlas.
Each run must end in one sentence and status 1, or in a picture of finite values that are not negative. The limits are 1
GB of memory and 5 seconds of one core where a picture of the built-in bear takes 2, and in proportion on slower
machines. `make hostile` runs it. The last line counts; findings decide the status."""

import argparse
import collections
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import threading
import time

import hostile_files
import images
from repository import ROOT, models_folder

SECONDS = 5
SECONDS_OF_BEAR = 2
MEGABYTES = 1000
TRIES = 3  # for runs that take too long: the machine may be busy
LONGEST_SECONDS = 60  # of one core; ten times as long by the clock
PICTURE = ("--size", "48x48", "--antialias", "1", "--quiet")
# A file cannot be blamed for time that depends on the number of surfels.
BOUNDARY = (*PICTURE, "--max-surfels", "32768")
PAPER = (*PICTURE, "--method", "paper", "--medium", "marble")
SKY_MODEL = "cube.obj"


class Run:
    """One run of the program, with its cost and its outputs."""

    def __init__(self, program, arguments, folder):
        self.arguments = arguments
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            process = subprocess.Popen([program, *arguments], cwd=folder, stdout=out, stderr=err, stdin=subprocess.DEVNULL,
                                       preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (LONGEST_SECONDS,) * 2))
            alarm = threading.Timer(10 * LONGEST_SECONDS, process.kill)
            alarm.start()
            _, status, used = os.wait4(process.pid, 0)
            alarm.cancel()
            # 2 means that the caller asked for a method that shows less.
            self.refusals = (1, 2) if "paper" in arguments else (1,)
            self.status = process.returncode = os.waitstatus_to_exitcode(status)
            self.seconds = used.ru_utime + used.ru_stime
            self.megabytes = used.ru_maxrss * 1024 / 1e6
            for stream in (out, err):
                stream.seek(0)
            self.out = out.read().decode(errors="replace")
            self.err = err.read().decode(errors="replace")

    def faults(self, output, most_seconds):
        """The faults of a run, whatever the file."""
        if self.seconds > most_seconds:
            yield f"took {self.seconds:.1f} s of one core"
        if self.megabytes > MEGABYTES:
            yield f"took {self.megabytes:.0f} MB"
        if self.status != 0 and self.status not in self.refusals:
            yield f"ended with status {self.status}: {self.err.strip()[-300:]}"
        elif self.status != 0:
            said = [line for line in self.err.splitlines() if not line.startswith(("note: ", "warning: "))]
            if len(said) != 1 or not said[0].startswith("opaline: "):
                yield f"refused by {len(said)} sentences: {self.err.strip()[-300:]}"
            if self.out or (output and output.exists()):
                yield "was refused, and has an output"
        elif output:
            yield from faults_of_picture(output)


def faults_of_picture(path):
    if not path.exists():
        yield "has no picture"
        return
    values = [value for pixel in images.read_exr(path.read_bytes()).pixels() for value in pixel]
    if any(not abs(value) < 1e38 for value in values):
        yield "has a value that is no number"
    if any(value < 0 for value in values):
        yield "has a negative value"


def commands(hostile):
    """Arguments, and whether they make a picture."""
    path = str(hostile.path)
    if hostile.path.suffix in hostile_files.SKIES:
        return [(("render", SKY_MODEL, "--environment", path, *BOUNDARY), True),
                (("compare", path, path), False)]
    return [(("info", path), False), (("render", path, *BOUNDARY), True), (("render", path, *PAPER), True)]


def judged(program, hostile, folder, most_seconds):
    """The file's runs and their faults. The paper's method may refuse sound files, since it shows less."""
    output = folder / f"picture-{threading.get_ident()}.exr"
    runs, faults = [], []
    for arguments, pictured in commands(hostile):
        output.unlink(missing_ok=True)
        outputs = ("-o", str(output)) if pictured else ()
        for _ in range(TRIES):
            run = Run(program, (*arguments, *outputs), folder)
            if run.seconds <= most_seconds:
                break
            most_seconds = max(most_seconds, limit_by(seconds_of_bear(program, folder)))  # the machine may be slower now
        runs.append(run)
        faults += [f"{' '.join(map(str, arguments))}: {fault}" for fault in run.faults(output if pictured else None, most_seconds)]
        shown = run.status == 0
        if "paper" not in arguments and hostile.must and shown != (hostile.must == "read"):
            faults.append(f"{' '.join(map(str, arguments))}: has to be {hostile.must}: {run.err.strip()}")
    output.unlink(missing_ok=True)
    return runs, faults


def print_table(results):
    kinds = collections.defaultdict(list)
    for hostile, runs, faults in results:
        kinds[hostile.kind].append((runs, faults))
    print(f"{'files':<28}{'number':>7}{'runs':>7}{'refused':>9}{'shown':>7}{'longest s':>11}{'most MB':>9}{'findings':>10}")
    for kind, rows in kinds.items():
        runs = [run for row, _ in rows for run in row]
        print(f"{kind:<28}{len(rows):>7}{len(runs):>7}{sum(run.status in run.refusals for run in runs):>9}"
              f"{sum(run.status == 0 for run in runs):>7}{max(run.seconds for run in runs):>11.1f}"
              f"{max(run.megabytes for run in runs):>9.0f}{sum(len(faults) for _, faults in rows):>10}")


def seconds_of_bear(program, folder):
    """Seconds of one core for the built-in bear, which measure the machine and its load."""
    seconds = Run(program, ("render", *BOUNDARY, "-o", "bear.exr"), folder).seconds
    (folder / "bear.exr").unlink()
    return seconds


def limit_by(bear):
    return min(SECONDS * max(bear / SECONDS_OF_BEAR, 1), LONGEST_SECONDS)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "release" / "bin" / "opaline")
    parser.add_argument("--models", type=pathlib.Path, default=models_folder(),
                        help="a folder whose small files are damaged too, where there is one")
    parser.add_argument("--copies", type=int, default=6, help="damaged ones of each sound file [6]")
    parser.add_argument("--every", type=int, default=1, help="tries one in so many [1]")
    parser.add_argument("--keep", type=pathlib.Path, default=ROOT / "build" / "hostile", help="where files with findings go")
    arguments = parser.parse_args()
    begin = time.monotonic()
    results = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        bear = min(seconds_of_bear(arguments.program.resolve(), folder) for _ in range(TRIES))
        most_seconds = limit_by(bear)
        for hostile in hostile_files.write_all(folder, arguments.models, arguments.copies)[::arguments.every]:
            runs, faults = judged(arguments.program.resolve(), hostile, folder, most_seconds)
            results.append((hostile, runs, faults))
            for fault in faults:
                print(fault, file=sys.stderr, flush=True)
            if faults and hostile.path.is_file():
                arguments.keep.mkdir(parents=True, exist_ok=True)
                shutil.copy(hostile.path, arguments.keep)
    print_table(results)
    print(f"a picture of the built-in bear took {bear:.1f} s of one core, so that {most_seconds:.1f} s are the limit")
    findings = sum(len(faults) for _, _, faults in results)
    print(f"{len(results)} files, {sum(len(runs) for _, runs, _ in results)} runs, {findings} findings, "
          f"{time.monotonic() - begin:.0f} s")
    sys.exit(findings > 0)


if __name__ == "__main__":
    main()
