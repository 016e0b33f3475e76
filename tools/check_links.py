#!/usr/bin/env python3
"""Checks that relative links, anchors and images of the documents exist, and that pictures in docs are small and
used."""

import posixpath
import re
import sys
import urllib.parse

from repository import ROOT, finish, read_text, tracked_files

LINK = re.compile(r"!?\[[^\]]*\]\(\s*<?([^)\s>]+)>?[^)]*\)|<(?:img|a)\b[^>]*?(?:src|href)=\"([^\"]+)\"")
FENCE = re.compile(r"^(```|~~~).*?^\1", re.MULTILINE | re.DOTALL)
HEADING = re.compile(r"^ {0,3}#{1,6}[ \t]+(.*?)(?:[ \t]+#+)?[ \t]*$", re.MULTILINE)
NAMED = re.compile(r"<[a-z][^>]*?\b(?:id|name)=\"([^\"]+)\"")
INLINE_LINK = re.compile(r"!?\[([^\]]*)\]\([^)]*\)")
NOT_OF_AN_ANCHOR = re.compile(r"[^\w\- ]")
PICTURES = (".png", ".jpg", ".jpeg", ".gif", ".svg", ".webp")
LARGEST_PICTURE_BYTES = 300 * 1024


def targets(text):
    """Relative targets of a document, each with its anchor, which may be empty."""
    for match in LINK.finditer(FENCE.sub("", text)):
        target = match[1] or match[2]
        if re.match(r"[a-z][a-z0-9+.-]*:", target):
            continue
        file, _, anchor = target.partition("#")
        yield urllib.parse.unquote(file), urllib.parse.unquote(anchor)


def anchors(text):
    """The anchors of a document by GitHub's rules. Headings keep letters of any script, digits, _ and -, in lower case,
    with hyphens for spaces. Repeated ones are numbered from 1."""
    text = FENCE.sub("", text)
    found = set(NAMED.findall(text))
    times = {}
    for match in HEADING.finditer(text):
        shown = re.sub(r"[*`]", "", INLINE_LINK.sub(r"\1", match[1]))
        slug = NOT_OF_AN_ANCHOR.sub("", shown.lower()).replace(" ", "-")
        number = times[slug] = times.get(slug, -1) + 1
        found.add(f"{slug}-{number}" if number else slug)
    return found


def check(documents, sizes):
    """documents: path -> text; sizes: every file of the repository -> bytes."""
    folders = {posixpath.dirname(path) for path in sizes}
    folders |= {parent for folder in folders for parent in ancestors(folder)}
    findings, used = [], set()
    for path, text in documents.items():
        for target, anchor in targets(text):
            resolved = posixpath.normpath(posixpath.join(posixpath.dirname(path), target)) if target else path
            used.add(resolved)
            if resolved not in sizes and resolved not in folders:
                findings.append(f"{path}: links to {target}, which does not exist")
            elif anchor and resolved in documents and anchor not in anchors(documents[resolved]):
                findings.append(f"{path}: links to {target}#{anchor}, but there is no such heading")
    for path, size in sizes.items():
        if path.startswith("docs/") and path.lower().endswith(PICTURES):
            if size > LARGEST_PICTURE_BYTES:
                findings.append(f"{path}: {size // 1024} KiB, more than {LARGEST_PICTURE_BYTES // 1024}")
            if path not in used:
                findings.append(f"{path}: no document shows it")
    return findings


def ancestors(folder):
    while folder:
        yield folder
        folder = posixpath.dirname(folder)
    yield "."


def main():
    files = tracked_files()
    documents = {path: read_text(ROOT / path) for path in files if path.endswith(".md")}
    finish("links", check(documents, {path: (ROOT / path).stat().st_size for path in files}))


if __name__ == "__main__":
    sys.exit(main())
