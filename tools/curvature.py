#!/usr/bin/env python3
"""How much more easily light leaves a curved surface than a plane. It is the factor on diffusion's 1/A with which as
much light leaves balls (curvature > 0), and the walls of hollows in an endless medium (< 0), as in Monte Carlo, over
the same factor for a half-space. Sources are uniform, or fall with the depth z as exp(-z). Lengths are in mean free
paths, scattering is isotropic, and the boundary is a smooth dielectric. The last column is what boundary transport uses
(src/shaders/lib/escape.glsl).

Then, for even light that has entered balls of skin1, the part that leaves again in red, green and blue. Needs NumPy and
SciPy.

  tools/curvature.py [ETA [SAMPLES]]
"""

import sys

import numpy as np
from collisions import grosjean, reflectance, robin
from scipy.linalg import solve_banded
from scipy.optimize import brentq

ALBEDOS = (0.96, 0.84, 0.68)
SKIN1 = ((0.74, 0.032), (0.88, 0.17), (1.01, 0.48))  # scattered and absorbed, 1/mm
RADII = (2.0, 4.0)  # mm
CURVATURES = (-0.5, -0.25, -0.125, 0.125, 0.25, 0.5)
SOURCES = (lambda z: np.ones_like(z), lambda z: np.exp(-z))
DEEPEST = 60.0
CELLS = 6000


class Body:
    """A ball of that curvature, the outside of one, or a half-space below z = 0."""

    def __init__(self, curvature):
        self.side = np.sign(curvature)
        self.radius = 1 / abs(curvature) if curvature else 0.0

    def start(self, count):
        places = np.zeros((count, 3))
        places[:, 2] = self.side * self.radius
        return places

    def depth(self, places):
        if self.side == 0:
            return -places[:, 2]
        return self.side * (self.radius - np.linalg.norm(places, axis=1))

    def way_out(self, places, directions):
        if self.side == 0:
            up = directions[:, 2]
            return np.where(up > 0, -places[:, 2] / np.maximum(up, 1e-12), np.inf)
        along = (places * directions).sum(1)
        root = along ** 2 - (places ** 2).sum(1) + self.radius ** 2
        way = -along + self.side * np.sqrt(np.maximum(root, 0))
        meets = (root > 0) & (along < 0) if self.side < 0 else np.full(len(places), True)
        return np.where(meets, np.maximum(way, 0), np.inf)

    def on_surface(self, places):
        """Places on the surface, slightly inside, and the normals that point out of the medium."""
        if self.side == 0:
            normals = np.zeros_like(places)
            normals[:, 2] = 1
            return places - places * normals - 1e-12 * normals, normals
        radial = places / np.linalg.norm(places, axis=1)[:, None]
        return radial * self.radius * (1 - self.side * 1e-10), self.side * radial


def leaving(eta):
    """Uniformly spaced cosines inside, and how much of even light leaves at each."""
    cosines = (np.arange(100_000) + 0.5) / 100_000
    return cosines, cosines * (1 - reflectance(1 / eta, cosines))


def exitance(body, albedo, eta, count, dice, sources=SOURCES):
    """The exitance for each source, by walks from the surface back to the sources."""
    cosines, leaves = leaving(eta)
    cumulative = np.cumsum(leaves)
    cosine = np.interp(dice.random(count), cumulative / cumulative[-1], cosines)
    places = body.start(count)
    angle = dice.uniform(0, 2 * np.pi, count)
    sine = np.sqrt(1 - cosine ** 2)
    ways = np.stack([sine * np.cos(angle), sine * np.sin(angle), -cosine], 1)
    weights = np.ones(count)
    sums = np.zeros(len(sources))
    while len(weights):
        left = -np.log(1 - dice.random(len(weights)))
        while True:
            way = body.way_out(places, ways)
            mirrored = np.where(left > way)[0]
            if not len(mirrored):
                break
            places[mirrored], normals = body.on_surface(places[mirrored] + way[mirrored, None] * ways[mirrored])
            up = np.clip((ways[mirrored] * normals).sum(1), 0, 1)
            weights[mirrored] *= reflectance(1 / eta, up)
            ways[mirrored] -= 2 * up[:, None] * normals
            left[mirrored] -= way[mirrored]
            kept = weights > 1e-7
            places, ways, weights, left = places[kept], ways[kept], weights[kept], left[kept]
        places = places + left[:, None] * ways
        for k, source in enumerate(sources):
            sums[k] += (weights * source(body.depth(places))).sum()
        weights = weights * albedo
        height = dice.uniform(-1, 1, len(weights))
        angle = dice.uniform(0, 2 * np.pi, len(weights))
        sine = np.sqrt(1 - height ** 2)
        ways = np.stack([sine * np.cos(angle), sine * np.sin(angle), height], 1)
        small = weights < 0.1
        kept = ~small | (dice.random(len(weights)) < 0.25)
        weights = np.where(small, 4 * weights, weights)
        places, ways, weights = places[kept], ways[kept], weights[kept]
    return sums / count * leaves.mean() / 2


def exitance_by_diffusion(curvature, albedo, over_a, source, thickness=None):
    """The exitance by Grosjean's diffusion, with the depth in cells. With a thickness, light leaves on the other side
    too."""
    diffusion = grosjean(albedo)
    deepest = thickness or (min(1 / curvature, DEEPEST) if curvature > 0 else DEEPEST)
    edges = np.linspace(0, deepest, CELLS + 1)
    middles = (edges[1:] + edges[:-1]) / 2
    volumes = (1 - curvature * middles) ** 2 * edges[1]
    between = diffusion * (1 - curvature * edges[1:-1]) ** 2 / edges[1]
    outwards = 1 / (2 / over_a + edges[1] / (2 * diffusion))
    bands = np.zeros((3, CELLS))
    bands[1] = (1 - albedo) * volumes
    bands[1, 0] += outwards
    if thickness:
        bands[1, -1] += outwards
    bands[1, 1:] += between
    bands[1, :-1] += between
    bands[0, 1:] = -between
    bands[2, :-1] = -between
    return outwards * solve_banded((1, 1), bands, source(middles) * volumes)[0]


def over_a_for(exact, curvature, albedo, source):
    return brentq(lambda it: exitance_by_diffusion(curvature, albedo, it, source) - exact, 1e-3, 50)


def main():
    eta = float(sys.argv[1]) if len(sys.argv) > 1 else 1.3
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 200_000
    dice = np.random.default_rng(1)
    print("albedo  curvature   even   exp(-z)   taken")
    for albedo in ALBEDOS:
        plane = [over_a_for(exact, 0, albedo, source)
                 for exact, source in zip(exitance(Body(0), albedo, eta, 2 * count, dice), SOURCES)]
        for curvature in CURVATURES:
            exact = exitance(Body(curvature), albedo, eta, count, dice)
            found = [over_a_for(e, curvature, albedo, source) / p for e, source, p in zip(exact, SOURCES, plane)]
            bend = 2 * grosjean(albedo) * curvature / robin(eta)
            print(f"{albedo:6} {curvature:10.3f}  {found[0]:6.3f}  {found[1]:6.3f}   {1 + 0.5 * bend / (1 + 3 * abs(bend)):6.3f}",
                  flush=True)
    print("radius   leaves again")
    for radius in RADII:
        left = []
        for scatters, absorbs in SKIN1:
            extinction = scatters + absorbs
            # Walks start like even light that enters. Absorption takes its share of every free path.
            even = exitance(Body(1 / (radius * extinction)), scatters / extinction, eta, 4 * count, dice)[0]
            left.append(1 - absorbs / extinction * 2 * even / leaving(eta)[1].mean())
        print(f"{radius:4} mm ", *(f" {part:.4f}" for part in left))


if __name__ == "__main__":
    main()
