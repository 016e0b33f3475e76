#!/usr/bin/env python3
"""The light that a half-space gives back, by Monte Carlo: per unit of flux that arrives along the normal, and from
everywhere. Light scatters by Henyey and Greenstein's phase function, and the boundary is a smooth dielectric. Prints
both, with their standard errors. Needs NumPy.

  tools/half_space.py SIGMA_S_PRIME SIGMA_A [G [ETA [PATHS]]]
"""

import sys

import numpy as np

from collisions import reflectance

LIGHT = 1e-3   # weights below it end by roulette
PARTS = 16     # of all paths, whose spread gives the error


def turned(random, cosine, g):
    """Cosines to the normal after scattering."""
    u = random.random(len(cosine))
    bend = 2 * u - 1 if abs(g) < 1e-3 else (1 + g * g - ((1 - g * g) / (1 - g + 2 * g * u)) ** 2) / (2 * g)
    across = np.sqrt(np.maximum((1 - cosine ** 2) * (1 - bend ** 2), 0))
    return np.clip(cosine * bend + across * np.cos(2 * np.pi * random.random(len(cosine))), -1, 1)


def given_back(random, albedo, g, eta, arrival):
    """Light that leaves after at least one collision, of paths that arrive with those cosines."""
    weight = 1 - reflectance(eta, arrival)
    cosine = np.sqrt(1 - (1 - arrival ** 2) / eta ** 2)
    depth = np.zeros(len(arrival))
    leaves = 0
    while len(weight) > 0:
        depth = depth - cosine * np.log(random.random(len(depth)))
        while (depth < 0).any():  # it is mirrored inside, and part of it leaves
            at = np.flatnonzero(depth < 0)
            mirrored = reflectance(1 / eta, -cosine[at])
            leaves += (weight[at] * (1 - mirrored)).sum()
            weight[at] *= mirrored
            cosine[at] *= -1
            depth[at] *= -1
        weight = weight * albedo
        cosine = turned(random, cosine, g)
        ends = (weight < LIGHT) & (random.random(len(weight)) < 0.9)
        weight = np.where(weight < LIGHT, 10 * weight, weight)[~ends]
        cosine, depth = cosine[~ends], depth[~ends]
    return leaves / len(arrival)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    reduced, absorbed, g, eta, paths = (*map(float, sys.argv[1:]), *(0, 1.3, 1e6)[len(sys.argv) - 3:])
    scattered = reduced / (1 - g)
    random = np.random.default_rng(1)
    count = int(paths / PARTS)
    for name, arrival in (("along the normal", lambda: np.ones(count)),
                          ("from everywhere", lambda: np.sqrt(random.random(count)))):
        parts = [given_back(random, scattered / (scattered + absorbed), g, eta, arrival()) for _ in range(PARTS)]
        print(f"{name}: {np.mean(parts):.4f} ± {np.std(parts) / np.sqrt(PARTS - 1):.4f}")


if __name__ == "__main__":
    main()
