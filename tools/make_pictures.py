#!/usr/bin/env python3
"""Makes the pictures of README and docs by the commands in tools/figures/pictures.json: all of them, or those named.
`make figures` runs it. Pictures that take minutes are made only if named, or with --all."""

import argparse
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys

from repository import ROOT, models_folder

IMAGES = ROOT / "docs" / "images"
MANIFEST = ROOT / "tools" / "figures" / "pictures.json"
BY_HAND = "by hand"


def entries():
    """Page and entry of all pictures made by a command."""
    return [(page, entry) for page, listed in json.loads(MANIFEST.read_text()).items() if page != BY_HAND
            for entry in listed]


def by_hand():
    return set(json.loads(MANIFEST.read_text())[BY_HAND])


def words_of(command, programs, models):
    """A command with the full paths of programs, scripts of the repository and models."""
    name, *arguments = shlex.split(command)
    if name == "opaline_figures":
        arguments += ["--into", "."]
    script = ROOT / name
    return [str(programs.get(name, script if script.is_file() else name)), *(str(models / word) if (models / word).is_file() else word for word in arguments)]


def convert(source, target, width=None):
    """Copies a picture, or makes a JPEG of that width."""
    if source.suffix == target.suffix and width is None:
        shutil.copyfile(source, target)
        return
    scale = ["-vf", f"scale={width}:-1:flags=area"] if width else []
    subprocess.run(["ffmpeg", "-loglevel", "error", "-y", "-i", str(source), *scale, "-q:v", "2", "-pix_fmt", "yuvj444p",
                    "-frames:v", "1", "-update", "1", str(target)], check=True)


def make(entry, programs, models, work, images):
    work.mkdir(parents=True, exist_ok=True)
    for command in entry["commands"]:
        print(command, flush=True)
        subprocess.run(words_of(command, programs, models), cwd=work, check=True,
                       env={**os.environ, "OPALINE": str(programs["opaline"])})
    for picture, made in entry["pictures"].items():
        convert(work / made, images / picture, entry.get("width"))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("pictures", nargs="*", metavar="PICTURE", help="as bear_gummy.jpg")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    parser.add_argument("--models", type=pathlib.Path, help="[OPALINE_MODELS, else ../shared/models]",
                        default=models_folder())
    arguments = parser.parse_args()
    known = {picture for _, entry in entries() for picture in entry["pictures"]}
    for picture in arguments.pictures:
        if picture not in known:
            sys.exit(f"no command makes {picture}; there are {' '.join(sorted(known))}")
    binaries = arguments.build.resolve() / "bin"
    programs = {name: binaries / name for name in ("opaline", "opaline_figures")}
    for _, entry in entries():
        wanted = set(entry["pictures"]) & set(arguments.pictures) if arguments.pictures else (
            arguments.all or not entry.get("long"))
        if not wanted:
            continue
        try:
            make(entry, programs, arguments.models.resolve(), ROOT / "build" / "pictures", IMAGES)
        except (subprocess.CalledProcessError, OSError) as error:
            sys.exit(f"figures: {error}")


if __name__ == "__main__":
    main()
