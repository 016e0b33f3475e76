#!/usr/bin/env python3
"""Runs all tests of a preset, or with --quick those so labelled whose program or data have changed since they last
passed. At the end it prints the output of failed tests, so that nobody has to search for it.

Memory that is allocated is filled, so that nothing works only because it happens to be 0: floats that nobody has set
are -1.7e38, the software device's too."""

import argparse
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree

from repository import ROOT, tracked_files

LONGEST_OUTPUT = 3000
CODE = (".cpp", ".h", ".py", ".txt", ".glsl")


def failing_cases(output):
    """Name and output of each case of a GoogleTest program that failed or did not finish."""
    for case in re.split(r"^\[ RUN      \] ", output, flags=re.MULTILINE)[1:]:
        name, _, said = case.partition("\n")
        end = re.search(r"^\[( *)(OK|FAILED|SKIPPED)( *)\] .*$", said, re.MULTILINE)
        if end is None or end[2] == "FAILED":
            yield name, said[:end.end()] if end else said + "\n(it never ended)"


def failures(report):
    """Name and end of the output of each failed test in ctest's JUnit report."""
    found = []
    for test in xml.etree.ElementTree.parse(report).getroot().iter("testcase"):
        if test.get("status") != "fail":
            continue
        output = (test.findtext("system-out") or "").strip()
        cases = [(f"{test.get('name')}: {case}", said) for case, said in failing_cases(output)]
        found += cases or [(test.get("name"), output)]
    return [(name, said.strip()[-LONGEST_OUTPUT:]) for name, said in found]


def skipped_cases(report):
    """The skipped cases of GoogleTest programs, with their reasons."""
    for test in xml.etree.ElementTree.parse(report).getroot().iter("testcase"):
        output = test.findtext("system-out") or ""
        yield from re.findall(r"^\[  SKIPPED \] (\S+) \(", output, re.MULTILINE)


def passed_tests(report):
    return {test.get("name") for test in xml.etree.ElementTree.parse(report).getroot().iter("testcase")
            if test.get("status") == "run"}


def quick_tests(preset):
    """Name -> the mark that a quick test leaves when it passes. It depends on the test's program and on all tests'
    data."""
    listing = subprocess.run(["ctest", "--preset", preset, "-L", "quick", "--show-only=json-v1"], cwd=ROOT,
                             capture_output=True, text=True, check=True)
    data = hashlib.sha256()
    for name in tracked_files():
        if name.startswith("tests/") and not name.endswith(CODE):
            data.update(name.encode() + b"\0" + (ROOT / name).read_bytes())
    marks = ROOT / "build" / preset / "passed"
    marks.mkdir(exist_ok=True)
    tests = {}
    for test in json.loads(listing.stdout)["tests"]:
        program = pathlib.Path(test["command"][0]).read_bytes()
        tests[test["name"]] = marks / hashlib.sha256(data.digest() + program).hexdigest()
    return tests


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("preset")
    parser.add_argument("--jobs", default="2")
    parser.add_argument("--quick", action="store_true")
    arguments = parser.parse_args()
    report = pathlib.Path(ROOT / "build" / f"tests-{arguments.preset}.xml")
    report.unlink(missing_ok=True)
    marks = quick_tests(arguments.preset)
    command = ["ctest", "--preset", arguments.preset, "-j", arguments.jobs, "--output-junit", report,
               "--test-output-size-passed", "1000000", "--test-output-size-failed", "1000000"]
    if arguments.quick:
        changed = [name for name, mark in marks.items() if not mark.exists()]
        if not changed:
            print("nothing has changed since the quick tests passed")
            return
        command += ["-R", f"^({'|'.join(map(re.escape, changed))})$"]
    status = subprocess.run(command, cwd=ROOT, check=False, env=os.environ | {"MALLOC_PERTURB_": "1"}).returncode
    if report.exists():
        for name in passed_tests(report) & marks.keys():
            marks[name].touch()
        for name in skipped_cases(report):
            print(f"skipped: {name}")
        for name, output in failures(report):
            print(f"\nfailed: {name}\n{output}")
    sys.exit(status)


if __name__ == "__main__":
    main()
