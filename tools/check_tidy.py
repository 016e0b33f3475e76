#!/usr/bin/env python3
"""clang-tidy on every file of the product, in parallel. What was clean and has not changed since, with
all the headers it includes, is not read again. Usage: check_tidy.py BUILD_FOLDER"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import subprocess
import sys

import clang_tools
from repository import ROOT, finish


def our_dependencies(build):
    """Object -> the files below the repository that it was compiled from, as ninja recorded them."""
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
    digest = hashlib.sha256(salt)
    digest.update(command.encode())
    for path in sorted(set(files)):
        digest.update(str(path.relative_to(ROOT)).encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()


def units(build, salt):
    """(source, fingerprint or None) of every translation unit that is ours."""
    dependencies = our_dependencies(build)
    for entry in json.loads((build / "compile_commands.json").read_text()):
        source = pathlib.Path(entry["directory"], entry["file"]).resolve()
        if not source.is_relative_to(ROOT) or source.is_relative_to(build):
            continue
        if source.is_relative_to(ROOT / "tests"):  # reading the test library takes longer than all else
            continue
        files = dependencies.get(entry["output"]) if "output" in entry else None
        if files is None:
            name = next((part for part in entry["command"].split() if part.endswith(".o")), "")
            files = dependencies.get(name)
        known = files is not None and source in files and all(path.is_file() for path in files)
        yield source, fingerprint(salt, entry["command"], files) if known else None


def tidy(program, build, source):
    result = subprocess.run([program, "-p", build, "--quiet", "--extra-arg=-Wno-unknown-warning-option", source], capture_output=True, text=True)
    return result.returncode == 0, result.stdout.strip() or result.stderr.strip()


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    program = clang_tools.find("clang-tidy")
    if program is None:
        return
    salt = (ROOT / ".clang-tidy").read_bytes() + clang_tools.VERSION.encode()
    clean = build / "tidy"
    clean.mkdir(exist_ok=True)
    waiting = [(source, key) for source, key in units(build, salt)
               if key is None or not (clean / key).exists()]
    findings = []
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        running = {pool.submit(tidy, program, build, source): (source, key) for source, key in waiting}
        for done, future in enumerate(concurrent.futures.as_completed(running), start=1):
            source, key = running[future]
            good, text = future.result()
            if good and key is not None:
                (clean / key).touch()
            elif not good:
                findings.append(text)
            print(f"clang-tidy [{done}/{len(waiting)}] {source.relative_to(ROOT)}", flush=True)
    finish("clang-tidy", findings)


if __name__ == "__main__":
    sys.exit(main())
