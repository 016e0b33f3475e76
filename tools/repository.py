"""What all checkers share: the files of the repository and the way a finding is reported."""

import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

SOURCE_FOLDERS = ("include", "src", "reference", "apps", "python", "examples", "tests", "bench", "tools",
                  "scripts", "cmake")


def models_folder():
    """Where models lie that are not in the repository."""
    return pathlib.Path(os.environ.get("OPALINE_MODELS") or ROOT.parent / "shared" / "models")


def tracked_files(root=ROOT):
    """Paths relative to the root, of what git tracks or would track, that exist."""
    listing = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=root, check=True, capture_output=True).stdout.decode()
    return sorted({name for name in listing.split("\0") if name and (root / name).is_file()})


def read_text(path):
    return path.read_text(encoding="utf-8", errors="replace")


def finish(title, findings):
    """Prints the findings and leaves with the status that make understands."""
    for finding in findings:
        print(finding, file=sys.stderr)
    if findings:
        print(f"{title}: {len(findings)} to mend", file=sys.stderr)
        sys.exit(1)
    print(f"{title}: ok")
