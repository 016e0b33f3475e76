#!/usr/bin/env python3
"""Runs all tests of a preset; in the end, what those that failed had printed, where nobody has to search for it."""

import argparse
import pathlib
import subprocess
import sys
import xml.etree.ElementTree

from repository import ROOT

LONGEST_OUTPUT = 3000


def failures(report):
    """Name and end of the output of each test that failed, of ctest's JUnit report."""
    cases = xml.etree.ElementTree.parse(report).getroot().iter("testcase")
    return [(case.get("name"), (case.findtext("system-out") or "").strip()[-LONGEST_OUTPUT:])
            for case in cases if case.get("status") == "fail"]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("preset")
    parser.add_argument("--jobs", default="2")
    arguments = parser.parse_args()
    report = pathlib.Path(ROOT / "build" / f"tests-{arguments.preset}.xml")
    report.unlink(missing_ok=True)
    status = subprocess.run(["ctest", "--preset", arguments.preset, "-j", arguments.jobs, "--output-junit", report],
                            cwd=ROOT, check=False).returncode
    if status and report.exists():
        for name, output in failures(report):
            print(f"\nfailed: {name}\n{output}")
    sys.exit(status)


if __name__ == "__main__":
    main()
