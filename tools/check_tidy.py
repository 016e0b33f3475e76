#!/usr/bin/env python3
"""Runs clang-tidy in parallel on every source file of the product. Reading headers takes most of its time, so files
with equal compiler flags are read together as one translation unit. Files that do not compile together, since they use
a name differently, are read separately. Files found clean in any checkout are skipped until they or their headers
change, unless --all is given."""

import argparse
import concurrent.futures
import contextlib
import hashlib
import itertools
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import time

import clang_tools
from repository import ROOT, finish

FILES_AT_ONCE = 48

# All checkouts share the marks of clean files, as they share a compiler cache.
MARKS = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "opaline" / "tidy"
UNUSED_DAYS = 30


def our_dependencies(build):
    """Object -> the files of the repository from which it was compiled, as ninja recorded them."""
    listing = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True)
    dependencies, current = {}, None
    for line in listing.stdout.splitlines():
        if line.startswith("    "):
            path = (build / line.strip()).resolve()
            if path.is_relative_to(ROOT):
                dependencies[current].append(path)
        elif ": #deps" in line:
            current = line.split(": #deps")[0]
            dependencies[current] = []
    return dependencies


def fingerprint(salt, command, files):
    """A digest of what clang-tidy reads, equal wherever the checkout is."""
    root = str(ROOT).encode()
    digest = hashlib.sha256(salt)
    digest.update(command.encode().replace(root, b""))
    for path in sorted(set(files)):
        digest.update(str(path.relative_to(ROOT)).encode() + b"\0" + path.read_bytes().replace(root, b""))
    return digest.hexdigest()


class Source:
    """A file to read: its compiler flags, and the mark it leaves when clean (None: always read)."""

    def __init__(self, path, flags, mark):
        self.path, self.flags, self.mark = path, flags, mark


def files_of(unit):
    """The source files in a unit of a unity build; for any other unit, the unit itself."""
    if unit.parent.name != "Unity":
        return [unit]
    return [pathlib.Path(name).resolve() for name in re.findall(r'^#include "(.+)"', unit.read_text(), re.MULTILINE)]


def sources(build, salt):
    """Every source file of ours, once."""
    dependencies = our_dependencies(build)
    seen = set()
    for entry in json.loads((build / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        at = words.index("-o")
        files = dependencies.get(words[at + 1])
        for path in files_of(pathlib.Path(entry["directory"], entry["file"]).resolve()):
            if not path.is_relative_to(ROOT) or path.is_relative_to(build) or path in seen:
                continue
            if path.is_relative_to(ROOT / "tests"):  # reading the test library takes longer than all else
                continue
            seen.add(path)
            known = files is not None and path in files and all(file.is_file() for file in files)
            name = str(path.relative_to(ROOT)).encode()
            mark = MARKS / fingerprint(salt + name, entry["command"], files) if known else None
            yield Source(path, tuple(words[1:at]), mark)


def was_clean(source):
    """Whether the file's mark exists. Using a mark keeps it from being forgotten."""
    if source.mark is None or not source.mark.exists():
        return False
    source.mark.touch()
    return True


def forget_unused_marks():
    oldest = time.time() - UNUSED_DAYS * 24 * 3600
    for mark in MARKS.iterdir():
        with contextlib.suppress(FileNotFoundError):  # another checkout may forget it at the same time
            if mark.stat().st_mtime < oldest:
                mark.unlink()


def batches(waiting):
    by_flags = sorted(waiting, key=lambda source: (source.flags, source.path))
    for _, group in itertools.groupby(by_flags, key=lambda source: source.flags):
        group = list(group)
        count = -(-len(group) // FILES_AT_ONCE)
        yield from (group[len(group) * i // count:len(group) * (i + 1) // count] for i in range(count))


def tidy(program, build, batch):
    """The findings of clang-tidy in these files as one text; empty if there are none."""
    if len(batch) == 1:
        unit = batch[0].path
    else:
        names = "".join(f'#include "{source.path}"\n' for source in batch)
        unit = build / "tidy" / f"{hashlib.sha256(names.encode()).hexdigest()[:16]}.cpp"
        unit.write_text(names)
    command = [program, f"--config-file={ROOT / '.clang-tidy'}", "--quiet", unit, "--", *batch[0].flags,
               "-Wno-unknown-warning-option", "-Wno-shadow"]  # of another file's name; the compiler looks file by file
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode == 0:
        for source in batch:
            if source.mark is not None:
                source.mark.touch()
        return ""
    if len(batch) > 1 and "clang-diagnostic-error" in result.stdout:
        wrong = set(re.findall(r"^(.+?):\d+:\d+: error: ", result.stdout, re.MULTILINE))
        apart = [source for source in batch if str(source.path) in wrong]
        apart = apart if 0 < len(apart) < len(batch) else batch[:len(batch) // 2]
        parts = apart, [source for source in batch if source not in apart]
        return "\n".join(filter(None, (tidy(program, build, part) for part in parts)))
    return result.stdout.strip() or result.stderr.strip()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=pathlib.Path, help="folder of a build whose objects are up to date")
    parser.add_argument("--all", action="store_true", help="read what was clean before, too")
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    program = clang_tools.find("clang-tidy")
    if program is None:
        return
    salt = (ROOT / ".clang-tidy").read_bytes() + clang_tools.VERSION.encode()
    (build / "tidy").mkdir(exist_ok=True)
    MARKS.mkdir(parents=True, exist_ok=True)
    forget_unused_marks()
    waiting = [source for source in sources(build, salt) if arguments.all or not was_clean(source)]
    findings, done = [], 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        # The largest batches first, so that no processor waits long for the last.
        largest_first = sorted(batches(waiting), key=len, reverse=True)
        running = {pool.submit(tidy, program, build, batch): batch for batch in largest_first}
        for future in concurrent.futures.as_completed(running):
            batch = running[future]
            done += len(batch)
            if future.result():
                findings.append(future.result())
            print(f"clang-tidy [{done}/{len(waiting)}] {batch[-1].path.relative_to(ROOT)}", flush=True)
    finish("clang-tidy", findings)


if __name__ == "__main__":
    sys.exit(main())
