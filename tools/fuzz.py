#!/usr/bin/env python3
"""Runs every fuzz target for some seconds, as many at once as there are cores. Inputs are the corpus of the repository
and what earlier runs added to it in build/. An input that ends a target is a finding, and is kept beside that corpus
with the command that repeats it. The last line counts targets, executions and findings, which also decide the
status."""

import argparse
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from repository import ROOT

COMPILER = "clang++-14"
PRESET = "fuzz"
BUILD = ROOT / "build" / PRESET
SEEDS = ROOT / "tests" / "fuzz" / "corpus"

SECONDS_OF_AN_INPUT = 25  # with sanitizers, on a busy machine
MEGABYTES = 2500  # including the sanitizers' own
MEGABYTES_AT_ONCE = 1000
LONGEST_INPUT = 8192


def require_fuzzer():
    """Exits unless clang has its fuzzer, which may be missing."""
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder, "target.cpp")
        source.write_text("#include <cstddef>\n#include <cstdint>\n"
                          'extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t*, std::size_t) { return 0; }\n')
        command = [COMPILER, "-fsanitize=fuzzer,address", source, "-o", source.with_suffix("")]
        if shutil.which(COMPILER) and subprocess.run(command, capture_output=True, check=False).returncode == 0:
            return
    sys.exit(f"fuzz: {COMPILER} with its fuzzer is missing; on Debian: apt-get install clang-14 libclang-rt-14-dev")


def build(jobs):
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    subprocess.run(["cmake", "--preset", PRESET, f"-DCMAKE_CXX_COMPILER={COMPILER}", *launcher], cwd=ROOT, check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", "--preset", PRESET, "-j", str(jobs), "--target", "fuzz_targets"], cwd=ROOT,
                   check=True)


class Outcome:
    """The result of one target: how many inputs were run, and what ended it, if anything."""

    def __init__(self, target, executions, finding):
        self.target, self.executions, self.finding = target, executions, finding


def executions_in(log):
    """The count in libFuzzer's summary, or else in its last line before it was stopped."""
    counts = re.findall(r"^(?:stat::number_of_executed_units:\s*|#)(\d+)", log, re.MULTILINE)
    return max(map(int, counts), default=0)


def reason_in(log):
    """The first message of the sanitizers, the fuzzer or a check of the target."""
    said = re.search(r"^.*(?:runtime error: |ERROR: |: Failure$).*$", log, re.MULTILINE)
    return said[0].strip() if said else "it ended for a reason that its log does not name"


def run(target, seconds, seed):
    name = target.name.removeprefix("fuzz_")
    work = BUILD / "fuzzing" / name
    corpus, findings, scratch = work / "corpus", work / "findings", work / "scratch"
    shutil.rmtree(scratch, ignore_errors=True)
    for folder in (corpus, findings, scratch):
        folder.mkdir(parents=True, exist_ok=True)
    known = set(findings.iterdir())
    log = work / "log"
    command = [target, f"-max_total_time={seconds}", f"-seed={seed}", f"-timeout={SECONDS_OF_AN_INPUT}",
               f"-rss_limit_mb={MEGABYTES}", f"-malloc_limit_mb={MEGABYTES_AT_ONCE}", f"-max_len={LONGEST_INPUT}",
               "-entropic=0",  # it would take most of the time
               "-print_final_stats=1", "-detect_leaks=1", f"-artifact_prefix={findings}/", corpus, SEEDS / name]
    with log.open("w") as output:
        status = subprocess.run(command, stdout=output, stderr=subprocess.STDOUT, check=False,
                                env=dict(os.environ, TMPDIR=str(scratch))).returncode
    text = log.read_text(errors="replace")
    if status == 0:
        return Outcome(name, executions_in(text), None)
    new = sorted(set(findings.iterdir()) - known)
    repeat = f"{target.relative_to(ROOT)} {new[0].relative_to(ROOT)}" if new else f"see {log.relative_to(ROOT)}"
    return Outcome(name, executions_in(text), f"{reason_in(text)}\n  {repeat}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=int, default=60, help="of each target")
    parser.add_argument("--seed", type=int, default=0, help="0: another one every time")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--no-build", action="store_true", help="with what was built before")
    parser.add_argument("targets", nargs="*", help="all of them")
    arguments = parser.parse_args()
    require_fuzzer()
    if not arguments.no_build:
        build(arguments.jobs)
    wanted = {f"fuzz_{name}" for name in arguments.targets}
    targets = [path for path in sorted((BUILD / "bin").glob("fuzz_*")) if not wanted or path.name in wanted]
    if not targets or len(targets) < len(wanted):
        sys.exit(f"fuzz: there are targets {' '.join(path.name[5:] for path in sorted((BUILD / 'bin').glob('fuzz_*')))}")
    outcomes = []
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for outcome in pool.map(lambda target: run(target, arguments.seconds, arguments.seed), targets):
            print(f"{outcome.target:>10}: {outcome.executions:>12,} executions", flush=True)
            if outcome.finding:
                print(f"  {outcome.finding}", flush=True)
            outcomes.append(outcome)
    findings = sum(outcome.finding is not None for outcome in outcomes)
    executions = sum(outcome.executions for outcome in outcomes)
    print(f"{len(outcomes)} targets, {executions} executions, {findings} findings")
    sys.exit(findings > 0)


if __name__ == "__main__":
    main()
