#!/usr/bin/env python3
"""The public headers are the reference, so every type and function in them needs a comment: above it, after it, or
above its group of lines. Members of documented types explain themselves or have a comment."""

import re
import sys

from repository import ROOT, finish, read_text, tracked_files

FOLDER = "include/opaline/"
TYPE = re.compile(r"(?:^|\s)(?:struct|class|union|enum(?: class)?)\s+(?:OPALINE_API\s+)?(\w+)")
ACCESS = re.compile(r"\b(public|protected|private)\s*:(?!:)")
# Needs no comment: defaulted functions, declarations of types defined elsewhere, specializations.
PLAIN = re.compile(r"=\s*(?:default|delete)$|^friend\b|^(?:struct|class|enum)\s+\w+$|^template\s*<>|^static_assert\b|^~")


def blanked(text):
    """The text without comments, literals and preprocessor lines; all lines keep their numbers."""
    text = re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', lambda found: re.sub(r"[^\n]", " ", found[0]), text, flags=re.DOTALL)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda found: re.sub(r"[^\n]", " ", found[0]), text, flags=re.MULTILINE)


def declarations(text):
    """(name or None if no comment is needed, first line, last line) of each visible declaration; lines count from 1."""
    scopes = [("namespace", None, True)]  # kind, name, whether what follows is public
    start, depth = 0, 0
    for position, character in enumerate(text):
        if character not in ";{}":
            continue
        if depth > 0:  # inside of a function or an initializer
            depth += {"{": 1, "}": -1}.get(character, 0)
            if depth == 0 and character == "}" and ended:
                start = position + 1
            continue
        kind, owner, public = scopes[-1]
        statement = text[start:position]
        for access in ACCESS.findall(statement):
            public = access == "public"
            scopes[-1] = (kind, owner, public)
        words = " ".join(ACCESS.sub(" ", statement).split())
        first = text.count("\n", 0, start + len(statement) - len(ACCESS.sub(lambda m: " " * len(m[0]), statement).lstrip())) + 1
        last = text.count("\n", 0, position) + 1
        visible = all(scope[2] for scope in scopes)
        if character == "}":
            scopes.pop()
            start = position + 1
            continue
        found = TYPE.search(words.split("(")[0].split("=")[0])
        if character == "{":
            if words.startswith(("namespace", "inline namespace")) or words.startswith("extern"):
                scopes.append(("namespace", None, True))
            elif found and not words.startswith("using"):
                if visible:
                    yield found[1], first, last
                kind = "enum" if "enum" in words.split(found[1])[0] else "type"
                scopes.append((kind, found[1], "class" not in words.split(found[1])[0] or kind == "enum"))
            else:
                depth, ended = 1, "(" in words and "=" not in words.split("(")[0]
                if visible and kind != "enum" and "(" in words:
                    yield name_of(words, owner), first, last
                if not ended:
                    continue
                continue
            start = position + 1
            continue
        if words and visible and kind != "enum":
            yield name_of(words, owner), first, last
        start = position + 1


def name_of(words, owner):
    """The declared name, or None where it needs no comment."""
    if PLAIN.search(words):
        return None
    if words.startswith(("using", "typedef")):
        return words.split()[1]
    function = re.search(r"(operator\s*\S+|~?\w+)\s*\(", words)
    if not function or function[1] == owner or function[1].startswith(("operator", "~")):
        return None
    if owner and re.match(r"[\w:<>,\s*&]+\(\*", words):
        return None  # a member that points to a function
    return function[1]


def opens(lines, line):
    """Whether the line opens a type or function, so that the next line is inside it."""
    return blanked(lines[line - 1]).rstrip().endswith("{")


def undocumented(path, text):
    lines = text.splitlines()
    findings, documented_until = [], 0
    for name, first, last in declarations(blanked(text)):
        above = lines[first - 2].strip() if first > 1 else ""
        inside = any("///" in line for line in lines[first - 1:last])
        documented = above.startswith(("///", "//", "* ", "*/")) or inside or documented_until == first - 1
        if documented:
            documented_until = 0 if opens(lines, last) else last
        elif name is not None:
            findings.append(f"{path}:{first}: {name} has no comment")
        elif documented_until != first - 1:
            documented_until = 0
    return findings


def main():
    findings = []
    for path in tracked_files():
        if path.startswith(FOLDER) and path.endswith((".h", ".h.in")):
            findings += undocumented(path, read_text(ROOT / path))
    finish("documented", findings)


if __name__ == "__main__":
    sys.exit(main())
