"""Finds clang-format and clang-tidy in the version for which the rules were written: others judge differently."""

import re
import shutil
import subprocess

VERSION = "14"


def find(tool):
    """The program's path, or None with a sentence on why its check is skipped."""
    seen = None
    for name in (f"{tool}-{VERSION}", tool):
        path = shutil.which(name)
        if path is None:
            continue
        text = subprocess.run([path, "--version"], capture_output=True, text=True, check=True).stdout
        seen = re.search(r"version (\d+)", text)[1]
        if seen == VERSION:
            return path
    reason = f"found version {seen}" if seen else "not installed"
    print(f"{tool}: NOT CHECKED, the rules are written for version {VERSION}, {reason}")
    return None
