#!/usr/bin/env python3
"""All figures of what the sum in object space costs on this machine's GPU: frames of a deforming body, of every
kind of motion, scaling, and the paper's Table 1. Refuses a machine that has only a software device."""

import argparse
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]

# Fastest first.
TYPES = ("discrete", "integrated", "virtual")
TABLE1_MODELS = ("teapot.ply", "buddha.ply", "max_planck.ply", "bunny.ply", "bunny_egg_a.ply", "bunny_egg_b.ply")

# Goals on a GPU in ms: for the tree's sum at visible pixels, and for a whole frame with the tree.
MOST_SCATTER_MS = .5
MOST_FRAME_MS = 1.5


def gpus(devices):
    """The devices of `opaline info --json` that are not software, fastest first."""
    return sorted((device for device in devices if device["type"] in TYPES),
                  key=lambda device: TYPES.index(device["type"]))


def choose(devices, wanted):
    """The device whose index or part of the name is `wanted`; the first GPU without it."""
    if not wanted:
        return next(iter(gpus(devices)), None)
    found = [device for device in gpus(devices)
             if wanted == str(device["index"]) or wanted.lower() in device["name"].lower()]
    return found[0] if found else None


def refusal(devices, wanted):
    there = ", ".join(f"{device['name']} ({device['type']})" for device in devices) or "none at all"
    asked = f"no GPU that --device {wanted} names" if wanted else "no GPU"
    return f"there is {asked}: figures of a software device say nothing about one; Vulkan devices here: {there}"


def models_folder():
    return pathlib.Path(os.environ.get("OPALINE_MODELS") or ROOT.parent / "shared" / "models")


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return lines + ["| " + " | ".join(row) + " |" for row in rows]


def passes_of(row, *names):
    return sum(row["passes_ms"].get(name, 0) for name in names)


def frame_lines(frame):
    scatter = {row["way"]: passes_of(row, "estimate", "scatter", "nearby") for row in frame["rows"]}
    whole = {row["way"]: row["frame_ms"] for row in frame["rows"]}
    lines = ["", f"## Frames of {frame['scene']}, deforming, {frame['lighting']}, {frame['size'][0]} x "
             f"{frame['size'][1]}", ""]
    lines += table(
        ("frame", "site", "ms", "opaque frames", "frames of the paper", "evaluations", "rms"),
        [("opaque", "", f"{frame['opaque_ms']:.3f}", "1", "", "", "")] +
        [(row["way"], row["site"], f"{row['frame_ms']:.3f}", f"{row['opaque_frames']:.2f}", f"{row['papers']:.2f}",
          f"{row['evaluations']:.1f}" if "evaluations" in row else "",
          f"{100 * row['rel_rmse']:.2f} %" if "rel_rmse" in row else "") for row in frame["rows"]])
    for name, figure, most in (("the tree's sum at fragments", scatter["tree fragment"], MOST_SCATTER_MS),
                               ("a whole frame by the tree at fragments", whole["tree fragment"], MOST_FRAME_MS)):
        lines += ["", f"Aim for {name}: {most} ms; measured {figure:.3f} ms."]
    lines += ["", "Passes of the frame by the tree at fragments, ms:", ""]
    passes = next(row for row in frame["rows"] if row["way"] == "tree fragment")["passes_ms"]
    return lines + table(passes, [[f"{ms:.3f}" for ms in passes.values()]])


def default_lines(frames):
    """One column per scene, so that passes can be compared."""
    rows = [frame["rows"][0] for frame in frames]
    passes = list(dict.fromkeys(name for row in rows for name in row["passes_ms"]))
    lines = ["", "## Default frames, ms", ""]
    return lines + table(
        ("", *(f"{frame['scene']}, {frame['medium']}" for frame in frames)),
        [(name, *(f"{row['passes_ms'][name]:.3f}" if name in row["passes_ms"] else "" for row in rows)) for name in passes] +
        [("**whole frame**", *(f"**{row['frame_ms']:.3f}**" for row in rows)),
         ("opaque frames", *(f"{row['opaque_frames']:.2f}" for row in rows)),
         ("dispatches, barriers", *(f"{row['dispatches']}, {row['barriers']}" for row in rows))])


def motion_lines(motion):
    return ["", "## Motion", ""] + table(
        ("motion", "ms", "of the still", "allowed"),
        [(row["motion"], f"{row['frame_ms']:.3f}", f"{row['ratio']:.3f}", f"{row['allowed']:g}")
         for row in motion["rows"]])


def scaling_lines(scaling):
    lines = ["", f"## Scaling, {scaling['scene']}, {scaling['size'][0]} x {scaling['size'][1]}"]
    for key, value, last in (("surfels", "max_surfels", "scatter_growth_per_doubling"), ("sigma_tr", "divisor", None),
                             ("tolerance", "tolerance", "rel_rmse")):
        lines += ["", *table(
            (value, "surfels", "gather ms", "scatter ms", "frame ms", "scatter", "frame", "evaluations", last or ""),
            [(f"{row[value]:.7g}", str(row["surfels"]), f"{row['gather_ms']:.3f}", f"{row['scatter_ms']:.3f}",
              f"{row['frame_ms']:.3f}", f"{row['scatter_ratio']:.2f}", f"{row['frame_ratio']:.2f}",
              f"{row['evaluations']:.1f}",
              f"{100 * row[last]:.3f} %" if last and row[last] is not None else "") for row in scaling[key]["rows"]])]
    return lines


def table1_lines(measured):
    return ["", "## Table 1, frames per second", ""] + table(
        ("data", "FTF", "VTF", "tree"),
        [(row["data"], f"{row['ftf_fps']:.1f}", f"{row['vtf_fps']:.1f}", f"{row['tree_fps']:.1f}")
         for row in measured["rows"]])


def report(figures):
    """The measurements as Markdown."""
    device = figures["device"]
    lines = [f"# {device['name']}, {device['driver']}"]
    for frame in figures["frames"]["ways"]:
        lines += frame_lines(frame)
    lines += default_lines(figures["frames"]["defaults"])
    lines += motion_lines(figures["motion"]) + scaling_lines(figures["scaling"])
    if figures["table1"]:
        lines += table1_lines(figures["table1"])
    return "\n".join(lines) + "\n"


def run_json(*command):
    print("+", *command, file=sys.stderr, flush=True)
    done = subprocess.run(command, stdout=subprocess.PIPE, check=False)
    if done.returncode != 0:
        sys.exit(f"{pathlib.Path(command[0]).name} failed with status {done.returncode}")
    return json.loads(done.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("programs", type=pathlib.Path, help="folder of opaline and its benchmarks")
    parser.add_argument("output", type=pathlib.Path, help="folder for bench_gpu.json and bench_gpu.md")
    parser.add_argument("--device", default="", help="index or part of a name [the first GPU]")
    arguments = parser.parse_args()
    opaline = arguments.programs / "opaline"

    devices = run_json(opaline, "info", "--json")["devices"]
    device = choose(devices, arguments.device)
    if device is None:
        sys.exit(refusal(devices, arguments.device))
    on = ("--json", "--device", str(device["index"]))
    figures = {"device": device,
               "frames": run_json(arguments.programs / "opaline_frame_bench", *on, "--frames", "101"),
               "motion": run_json(arguments.programs / "opaline_motion_bench", *on, "--frames", "26"),
               "scaling": run_json(opaline, "bench", "scaling", *on, "--size", "1024", "--medium", "marble", "--frames",
                                   "50"),
               "table1": None}
    models = models_folder()
    if all((models / name).is_file() for name in TABLE1_MODELS):
        figures["table1"] = run_json(opaline, "bench", "table1", *on, "--models", models, "--frames", "100")
    else:
        print(f"without Table 1: not all of its models are in {models}", file=sys.stderr)

    (arguments.output / "bench_gpu.json").write_text(json.dumps(figures, indent=2) + "\n")
    text = report(figures)
    (arguments.output / "bench_gpu.md").write_text(text)
    print(text)
    print(f"written to {arguments.output}: bench_gpu.json, bench_gpu.md", file=sys.stderr)


if __name__ == "__main__":
    main()
