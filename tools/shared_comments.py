#!/usr/bin/env python3
"""A filter of public headers for Doxygen: a comment above a group of declarations applies to each of them, and the
first comment of a header to the file."""

import pathlib
import re
import sys

from check_documented import blanked, declarations, opens


def comment_above(lines, line):
    """The comment that ends right before a line, in the form that Doxygen reads; lines count from 1."""
    first = line - 1
    while first > 0 and lines[first - 1].strip().startswith("//"):
        first -= 1
    return [re.sub(r"//+", "///", text, count=1) for text in lines[first:line - 1]]


def shared(text):
    lines = text.splitlines()
    above = {}  # line -> comment to put before it
    group, until = [], 0
    for _, first, last in declarations(blanked(text)):
        own = comment_above(lines, first)
        if own:
            group, until = [] if opens(lines, last) else own, last
        elif any("///" in line for line in lines[first - 1:last]):
            group, until = [], last
        elif until == first - 1 and group:
            above[first] = [re.match(r"\s*", lines[first - 1])[0] + line.strip() for line in group]
            until = last
        else:
            group = []
    out = ["/// @file"]
    for number, line in enumerate(lines, 1):
        out += above.get(number, []) + [line]
    return "\n".join(out) + "\n"


if __name__ == "__main__":
    sys.stdout.write(shared(pathlib.Path(sys.argv[1]).read_text()))
