#!/usr/bin/env python3
"""Relative links and images of the documents lead somewhere; pictures in docs are small and used."""

import posixpath
import re
import sys
import urllib.parse

from repository import ROOT, finish, read_text, tracked_files

LINK = re.compile(r"!?\[[^\]]*\]\(\s*<?([^)\s>]+)>?[^)]*\)|<(?:img|a)\b[^>]*?(?:src|href)=\"([^\"]+)\"")
FENCE = re.compile(r"^(```|~~~).*?^\1", re.MULTILINE | re.DOTALL)
PICTURES = (".png", ".jpg", ".jpeg", ".gif", ".svg", ".webp")
LARGEST_PICTURE_BYTES = 300 * 1024


def targets(text):
    """Relative targets of a document, without the part after #."""
    for match in LINK.finditer(FENCE.sub("", text)):
        target = match[1] or match[2]
        if re.match(r"[a-z][a-z0-9+.-]*:", target) or target.startswith("#"):
            continue
        yield urllib.parse.unquote(target.split("#")[0])


def check(documents, sizes):
    """documents: path -> text; sizes: every file of the repository -> bytes."""
    folders = {posixpath.dirname(path) for path in sizes}
    folders |= {parent for folder in folders for parent in ancestors(folder)}
    findings, used = [], set()
    for path, text in documents.items():
        for target in targets(text):
            resolved = posixpath.normpath(posixpath.join(posixpath.dirname(path), target))
            used.add(resolved)
            if resolved not in sizes and resolved not in folders:
                findings.append(f"{path}: links to {target}, which does not exist")
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
