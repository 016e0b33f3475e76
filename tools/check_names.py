#!/usr/bin/env python3
"""Checks that file names are snake_case, that no source names a path of one machine or promises future work, that no
message of the library names a command-line option, and that the library waits for an idle device in one place only."""

import re
import sys

from repository import ROOT, SOURCE_FOLDERS, finish, read_text, tracked_files

SNAKE_CASE = re.compile(r"^[a-z0-9_]+(\.[a-z0-9_]+)*$")
# Names that others prescribe or that are typed at a prompt.
OTHER_NAMES = re.compile(r"^(CMakeLists\.txt|(Opaline|Find)\w+\.cmake(\.in)?|README\.md|[a-z0-9-]+\.sh)$")
TEXT = (".h", ".cpp", ".glsl", ".py", ".sh", ".cmake", ".txt", ".toml", ".json", ".md", "Makefile")
MACHINE_PATH = re.compile(r"(?<![\w.~-])/(?:work|home|root|farm|tmp|Users)(?:/|\b(?=[\"'\s]))")
LATER = re.compile(r"\b(?:TO" r"DO|FIX" r"ME|X" r"XX)\b")
# The library has fields; only programs know which options set them.
LIBRARY = ("include/", "src/", "reference/")
STRING = re.compile(r'"(?:[^"\\]|\\.)*"')
OPTION = re.compile(r"(?<![\w-])--[a-z]")
# Frames and edits wait for submissions by number. Only the destructor of the device waits for everything.
WAIT_IDLE = re.compile(r"vk(?:Device|Queue)WaitIdle\(")
WAITS_IDLE = "src/gpu/device.cpp"
# Data from outside keep the words of their source.
EXEMPT = ("LICENSE",)


def check_name(path):
    parts = path.split("/")
    if parts[0] not in SOURCE_FOLDERS:
        return []
    wrong = [part for part in parts if not SNAKE_CASE.match(part) and not OTHER_NAMES.match(part)]
    return [f"{path}: {part} is not snake_case" for part in wrong]


def check_text(path, text):
    findings = []
    for number, line in enumerate(text.splitlines(), start=1):
        if MACHINE_PATH.search(line):
            findings.append(f"{path}:{number}: a path of one machine")
        if LATER.search(line):
            findings.append(f"{path}:{number}: work put off to later")
        if path.startswith(LIBRARY) and path.endswith((".h", ".cpp")) and OPTION.search(" ".join(STRING.findall(line))):
            findings.append(f"{path}:{number}: a message of the library names an option of the command line")
        if path.startswith("src/") and path != WAITS_IDLE and WAIT_IDLE.search(line):
            findings.append(f"{path}:{number}: waits until the device is idle")
    return findings


def main():
    findings = []
    for path in tracked_files():
        findings += check_name(path)
        if path.endswith(TEXT) and path not in EXEMPT:
            findings += check_text(path, read_text(ROOT / path))
    finish("names", findings)


if __name__ == "__main__":
    sys.exit(main())
