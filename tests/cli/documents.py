"""The commands and option names that README.md and docs/ show."""

import pathlib
import re
import shlex

ROOT = pathlib.Path(__file__).resolve().parents[2]
FENCE = re.compile(r"^```(\w*)\n(.*?)^```", re.MULTILINE | re.DOTALL)
SPAN = re.compile(r"`(opaline [^`]+)`")
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*[a-z]")


def pages():
    """Path beside the root -> text."""
    return {str(path.relative_to(ROOT)): path.read_text()
            for path in (ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")))}


def blocks(text, language):
    return [match[2] for match in FENCE.finditer(text) if match[1] == language]


def commands(text):
    """The words of every command line of the program in page order, as a shell would pass them: those in blocks, and
    those in the text that have options."""
    variables, found = {}, []
    for match in re.finditer(f"(?P<block>{FENCE.pattern})|{SPAN.pattern}", text, re.MULTILINE | re.DOTALL):
        if match["block"] is None:
            words = shlex.split(match[match.lastindex])
            if any(word.startswith("-") for word in words) and not any(word.isupper() for word in words):
                found.append(words)
            continue
        if not match["block"].startswith(("```\n", "```sh\n")):
            continue
        for line in match["block"].replace("\\\n", " ").splitlines():
            assignment = re.match(r'([A-Z]+)="(.*)"$', line)
            if assignment:
                variables[assignment[1]] = assignment[2]
            elif line.startswith("opaline "):
                filled = re.sub(r"\$([A-Z]+)", lambda name: variables[name[1]], line)
                found.append(shlex.split(filled, comments=True))
    return found


def options(text):
    """Everything that looks like an option, except in code."""
    return set(OPTION.findall(FENCE.sub(lambda block: "" if block[1] == "cpp" else block[0], text)))
