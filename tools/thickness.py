#!/usr/bin/env python3
"""The light that diffusion lets out of a slab on the lit side and on the other, relative to Monte Carlo, in percent:
with the plane's 1/A, and with 1/A reduced as boundary transport does in thin parts (src/shaders/lib/escape.glsl).
Sources fall with the depth z as exp(-z). Lengths are in mean free paths, scattering is isotropic, and both boundaries
are smooth dielectrics. Needs NumPy and SciPy.

  tools/thickness.py [ETA [SAMPLES]]
"""

import sys

import numpy as np
from collisions import grosjean, robin
from curvature import ALBEDOS, exitance, exitance_by_diffusion

THICKNESSES = (0.15, 0.3, 0.5, 1.0, 2.0, 4.0)


class Slab:
    """A slab between z = 0 and z = -thickness."""

    def __init__(self, thickness):
        self.thickness = thickness

    def start(self, count):
        return np.zeros((count, 3))

    def depth(self, places):
        return -places[:, 2]

    def way_out(self, places, directions):
        z, up = places[:, 2], directions[:, 2]
        return np.where(up > 0, -z / np.maximum(up, 1e-12), (-self.thickness - z) / np.minimum(up, -1e-12))

    def on_surface(self, places):
        above = places[:, 2] > -self.thickness / 2
        normals = np.zeros_like(places)
        normals[:, 2] = np.where(above, 1, -1)
        inside = places.copy()
        inside[:, 2] = np.where(above, -1e-12, 1e-12 - self.thickness)
        return inside, normals


def of_plane(albedo, eta):
    """1/A of a plane, as in escape.glsl."""
    a = robin(eta)
    dark = 1 - albedo
    excess = (1 - 0.47 / a ** 2) * dark / (1 + 3.6 * dark)
    inwards = 2 * a * np.sqrt(grosjean(albedo) * dark)
    return inwards / (inwards + excess * (1 + inwards)) / a


def main():
    eta = float(sys.argv[1]) if len(sys.argv) > 1 else 1.3
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 400_000
    dice = np.random.default_rng(1)
    print("albedo  thickness   as on a plane    taken")
    for albedo in ALBEDOS:
        plane = of_plane(albedo, eta)
        for thickness in THICKNESSES:
            sources = (lambda z: np.exp(-z), lambda z, whole=thickness: np.exp(z - whole))
            exact = exitance(Slab(thickness), albedo, eta, count, dice, sources)
            taken = plane * (1 - np.exp(-1.3 * max(thickness, 0.2)))
            off = [[100 * (exitance_by_diffusion(0, albedo, over_a, source, thickness) / e - 1)
                    for e, source in zip(exact, sources)] for over_a in (plane, taken)]
            print(f"{albedo:6} {thickness:10.2f}   ", *(f" {lit:+6.1f} {other:+6.1f} " for lit, other in off), flush=True)


if __name__ == "__main__":
    main()
