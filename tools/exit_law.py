#!/usr/bin/env python3
"""The directions in which light leaves a slab, computed exactly, and the errors of two laws: even light, and
src/shaders/lib/exit_law.glsl. Scattering is isotropic, and both boundaries are smooth dielectrics. For each thickness
in mean free paths and each albedo it prints the largest error of each law up to 75 degrees, for light along the normal,
at 60 degrees and from everywhere, on the lit side and on the other. --table prints instead the radiance over even
radiance, for light along the normal, at 0, 30, 60 and 75 degrees. Needs NumPy.

  tools/exit_law.py [--table] [ETA]
"""

import sys

import numpy as np

from collisions import directions, reflectance

CELLS = 240
THICKNESSES = (0.5, 1, 2, 4, 8)
ALBEDOS = (0.9999, 0.96, 0.84, 0.68)
DEGREES = np.array([0, 15, 30, 45, 60, 75])


def inside(eta, cosine):
    return np.sqrt(1 - (1 - cosine ** 2) / eta ** 2)


def leaving(eta):
    """Cosines outside, and the share of even light from below that leaves there; the shares sum to 1."""
    points, weights = np.polynomial.legendre.leggauss(96)
    cosines = (points + 1) / 2
    shares = weights * cosines * (1 - reflectance(eta, cosines))
    return cosines, shares / shares.sum()


class Slab:
    """A slab between 0 and `thickness`, with cells that are small at either side."""

    def __init__(self, eta, thickness):
        self.eta, self.thickness = eta, thickness
        along = np.linspace(0, 1, CELLS + 1)
        self.edges = thickness * along ** 2 * (3 - 2 * along)
        self.sizes = np.diff(self.edges)
        self.collides = self.transfer()

    def between(self, cosine, mirrored):
        """For light that goes back and forth between the boundaries: how much is left after each round, and where it
        collides on the way from either boundary."""
        within = -np.expm1(-self.sizes / cosine)
        down = within * np.exp(-self.edges[:-1] / cosine)
        up = within * np.exp(-(self.thickness - self.edges[1:]) / cosine)
        through = np.exp(-self.thickness / cosine)
        return down, up, through, 1 / (1 - (mirrored * through) ** 2)

    def arrives(self, cosine, mirrored):
        """For light that starts evenly in each cell: how much reaches the first and the second boundary, over all
        rounds."""
        down, up, through, rounds = self.between(cosine, mirrored)
        first, other = (cosine / self.sizes * each for each in (down, up))
        return rounds * (first + mirrored * through * other), rounds * (other + mirrored * through * first)

    def transfer(self):
        """Where light from one cell collides next, by target and source cell."""
        below = np.tril(np.ones((CELLS, CELLS)), -1)
        apart = np.maximum(np.subtract.outer(self.edges[:-1], self.edges[1:]), 0)
        collides = np.zeros((CELLS, CELLS))
        for cosine, weight, mirrored in zip(*directions(self.eta)):
            within = -np.expm1(-self.sizes / cosine)
            out = cosine / self.sizes * within
            between = below * np.exp(-apart / cosine)
            down, up, _, _ = self.between(cosine, mirrored)
            first, other = self.arrives(cosine, mirrored)
            collides += weight / 2 * np.outer(within, out) * (between + between.T)
            collides += weight / 2 * mirrored * (np.outer(down, first) + np.outer(up, other))
            collides[np.diag_indices(CELLS)] += weight * (1 - out)
        return collides

    def beam(self, cosine):
        """First collisions of light that has entered with that cosine inside."""
        mirrored = float(reflectance(1 / self.eta, cosine))
        down, up, through, rounds = self.between(cosine, mirrored)
        return rounds * (down + mirrored * through * up)

    def lights(self):
        cosines, shares = leaving(self.eta)
        yield self.beam(1.0)
        yield self.beam(inside(self.eta, 0.5))
        yield sum(share * self.beam(each) for each, share in zip(inside(self.eta, cosines), shares))

    def radiance(self, sources, cosines):
        """Radiance on the lit side and on the other, over that of as much even light, at cosines outside."""
        def below(each):
            within = inside(self.eta, each)
            return np.array([sources @ side / cosine for cosine, mirrored in zip(within, reflectance(self.eta, each))
                             for side in self.arrives(cosine, mirrored)]).reshape(-1, 2).T
        everywhere, shares = leaving(self.eta)
        return below(cosines) / (below(everywhere) @ shares)[:, None]

    def sources(self, first, albedo):
        return np.linalg.solve(np.eye(CELLS) - albedo * self.collides, first)


def law(eta, albedo, thickness, cosines, lit):
    """exitLaw() with its mean over directions by quadrature."""
    diffusion = (2 * (1 - albedo) + albedo) / 3
    decay = np.sqrt((1 - albedo) / diffusion)
    points, weights = np.polynomial.legendre.leggauss(400)
    across = (points + 1) / 2
    mirrored = weights / 2 * reflectance(1 / eta, across) * across
    robin = (1 + 3 * (mirrored * across).sum()) / (1 - 2 * mirrored.sum())
    slope = 1 / (2 * robin * diffusion)

    def gathered(outside):
        cosine = inside(eta, outside)
        through = np.exp(-thickness / cosine)
        sums = (1 - through * np.exp(-thickness * decay)) / (1 + decay * cosine)
        if not lit:
            sums = 1 - through + slope * (cosine * (1 - through) - thickness * through)
        return sums / (1 - reflectance(eta, outside) * through)
    everywhere, shares = leaving(eta)
    return gathered(cosines) / (gathered(everywhere) @ shares)


def main():
    table = "--table" in sys.argv
    numbers = [float(word) for word in sys.argv[1:] if word != "--table"]
    eta = numbers[0] if numbers else 1.3
    cosines = np.cos(np.radians(DEGREES))
    if not table:
        print("thickness albedo   lit side: even, law   other side: even, law   (largest error, %)")
    for thickness in THICKNESSES:
        slab = Slab(eta, thickness)
        for albedo in ALBEDOS:
            exact = [slab.radiance(slab.sources(first, albedo), cosines) for first in slab.lights()]
            if table:
                print(f"{thickness:<9} {albedo:<8} " +
                      "   ".join(" ".join(f"{each:.4f}" for each in side[[0, 2, 4, 5]]) for side in exact[0]))
                continue
            worst = [100 * max(np.abs(found / each[side] - 1).max() for each in exact)
                     for side in (0, 1) for found in (1, law(eta, albedo, thickness, cosines, side == 0))]
            print(f"{thickness:<9} {albedo:<8} {worst[0]:8.1f} {worst[1]:6.1f} {worst[2]:14.1f} {worst[3]:6.1f}")


if __name__ == "__main__":
    main()
