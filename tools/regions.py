#!/usr/bin/env python3
"""Tells where a picture of exitance is wrong, in blocks of 8×8 pixels: lit ones, edges, others brighter than the mean,
and the rest. Prints for each group its share of the light, its part of the block error relative to the mean, and its
excess of brightness in red, green and blue.

  tools/regions.py ours.exr truth.csv irradiance.exr normal.exr

The truth is two runs of the path reference in the format of blocks.py; their noise is subtracted from the error. A
block is lit where the irradiance is over a hundredth of the largest. It is an edge where it contains background, or
where the mean normal is over 63° from the camera's axis, z.
"""

import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "tests" / "cli"))

import images
from blocks import EDGE, blocks

REGIONS = ("lit", "edges", "bright", "rest", "all")


def region(covered, irradiance, facing, brightness):
    """The group of a block, with irradiance relative to the largest and brightness relative to the mean."""
    if irradiance > 0.01:
        return "lit"
    if covered < EDGE ** 2 or facing < 0.45:
        return "edges"
    return "bright" if brightness > 1 else "rest"


def truth(name):
    """Both runs, each in the format of blocks()."""
    runs = ({}, {})
    with open(name, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            for run, prefix in zip(runs, ("first", "second")):
                run[int(row["block_x"]), int(row["block_y"])] = [
                    int(row["covered"]), *(float(row[f"{prefix}_{c}"]) for c in "rgb")]
    return runs


def main():
    ours, irradiance, normal = (
        blocks(images.read_exr(pathlib.Path(name).read_bytes())) for name in (sys.argv[1], *sys.argv[3:5]))
    first, second = truth(sys.argv[2])
    pixels = sum(entry[0] for entry in first.values())
    mean = [sum(run[at][1 + c] for run in (first, second) for at in first) / 2 * EDGE ** 2 / pixels for c in range(3)]
    brightest = max(entry[2] for entry in irradiance.values())
    sums = {name: [0, [0] * 3, [0] * 3, [0] * 3] for name in REGIONS}
    for at, entry in first.items():
        whole = EDGE ** 2 / entry[0]
        name = region(entry[0], irradiance[at][2] / brightest, normal[at][3] * whole,
                      entry[2] * whole / mean[1])
        for where in (name, "all"):
            number, light, found, squares = sums[where]
            sums[where][0] = number + 1
            for c in range(3):
                light[c] += (entry[1 + c] + second[at][1 + c]) / 2
                found[c] += ours[at][1 + c]
                squares[c] += (ours[at][1 + c] - entry[1 + c]) * (ours[at][1 + c] - second[at][1 + c])
    total = sums["all"][1]
    print("where   blocks  light, %        error, %              too bright, %")
    for name, (number, light, found, squares) in sums.items():
        share = " ".join(f"{100 * light[c] / total[c]:4.0f}" for c in range(3))
        error = " ".join(f"{100 * (max(squares[c], 0) / 1024) ** 0.5 / mean[c]:6.1f}" for c in range(3))
        bright = " ".join(f"{100 * (found[c] / light[c] - 1):+6.1f}" if light[c] else "     -" for c in range(3))
        print(f"{name:7} {number:6}  {share}  {error}  {bright}")


if __name__ == "__main__":
    main()
