"""Shared by all checkers: the files of the repository, and how findings are reported."""

import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

SOURCE_FOLDERS = ("include", "src", "reference", "apps", "python", "examples", "tests", "bench", "tools",
                  "scripts", "cmake")


def models_folder():
    """The folder of models that are not in the repository."""
    return pathlib.Path(os.environ.get("OPALINE_MODELS") or ROOT.parent / "shared" / "models")


def tracked_files(root=ROOT):
    """Existing files that git tracks or would track, relative to the root."""
    listing = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=root, check=True, capture_output=True).stdout.decode()
    return sorted({name for name in listing.split("\0") if name and (root / name).is_file()})


def read_text(path):
    return path.read_text(encoding="utf-8", errors="replace")


def finish(title, findings):
    """Prints the findings and exits with the status for make."""
    for finding in findings:
        print(finding, file=sys.stderr)
    if findings:
        print(f"{title}: {len(findings)} to mend", file=sys.stderr)
        sys.exit(1)
    print(f"{title}: ok")
