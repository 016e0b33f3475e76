#!/usr/bin/env python3
"""Turns two pictures of the same scene into means over blocks of 8×8 pixels, as a table: each block
that has something in it, how many of its pixels the object covers and both pictures' means over all
64, background 0.

  tools/blocks.py run1.exr run2.exr > blocks.csv
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "tests" / "cli"))

import images

EDGE = 8


def blocks(picture):
    """Number of covered pixels and mean colour by block."""
    table = {}
    for y in range(picture.height):
        for x in range(picture.width):
            pixel = picture.at(x, y)
            if pixel[3] > 0:
                entry = table.setdefault((x // EDGE, y // EDGE), [0, 0, 0, 0])
                entry[0] += 1
                for channel in range(3):
                    entry[1 + channel] += pixel[channel] / EDGE ** 2
    return table


def main():
    first, second = (blocks(images.read_exr(pathlib.Path(name).read_bytes())) for name in sys.argv[1:3])
    if {at: entry[0] for at, entry in first.items()} != {at: entry[0] for at, entry in second.items()}:
        sys.exit("the pictures do not cover the same pixels")
    print("block_x,block_y,covered,first_r,first_g,first_b,second_r,second_g,second_b")
    for (x, y), entry in sorted(first.items(), key=lambda item: item[0][::-1]):
        values = entry[1:] + second[x, y][1:]
        print(f"{x},{y},{entry[0]}," + ",".join(f"{value:.5g}" for value in values))


if __name__ == "__main__":
    main()
