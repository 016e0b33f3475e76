"""The keys that docs/json.md documents, and those that the program prints."""

import pathlib
import re

DOCUMENT = pathlib.Path(__file__).resolve().parents[2] / "docs" / "json.md"
MEDIUM = {"name", "sigma_s_per_mm", "sigma_a_per_mm", "eta", "g", "mean_free_path_mm", "diffusion_length_mm"}


def documented(section):
    """The keys in the first column of the tables of a section."""
    body = DOCUMENT.read_text().split(f"\n## {section}\n")[1].split("\n## ")[0]
    rows = [line.split("|")[1] for line in body.splitlines() if line.startswith("| `")]
    return {key for row in rows for key in re.findall(r"`([^`]+)`", row)}


def keys(value, path=""):
    """The printed keys in the document's notation."""
    if isinstance(value, dict) and set(value) == {"r", "g", "b"} and not isinstance(value["r"], dict):
        return {path}
    if isinstance(value, dict):
        return {found for name, inner in value.items() for found in keys(inner, f"{path}.{name}" if path else name)}
    if value == []:
        return set()  # whose elements would have keys, nobody can tell
    if isinstance(value, list) and any(isinstance(inner, (dict, str)) for inner in value):
        return {found for inner in value for found in keys(inner, f"{path}[]")}
    return {path}


def without_medium(found, prefix):
    """The keys with each medium as a single key; its own keys are those of `media`."""
    inner = {key.removeprefix(prefix + ".") for key in found if key.startswith(prefix + ".")}
    assert inner == MEDIUM, inner
    return {key for key in found if not key.startswith(prefix + ".")} | {prefix}
