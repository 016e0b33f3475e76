#!/usr/bin/env python3
"""All C++ is as clang-format would write it. --fix makes it so."""

import subprocess
import sys

import clang_tools
from repository import ROOT, finish, tracked_files


def main():
    program = clang_tools.find("clang-format")
    if program is None:
        return
    files = [path for path in tracked_files() if path.endswith((".h", ".cpp"))]
    if "--fix" in sys.argv[1:]:
        subprocess.run([program, "-i", *files], cwd=ROOT, check=True)
        return
    result = subprocess.run([program, "--dry-run", *files], cwd=ROOT, capture_output=True, text=True)
    wrong = [line for line in result.stderr.splitlines() if "clang-format-violations" in line]
    if result.returncode != 0 and not wrong:
        wrong = [result.stderr.strip()]
    if wrong:
        wrong.append("make format mends this")
    finish("format", wrong)


if __name__ == "__main__":
    sys.exit(main())
