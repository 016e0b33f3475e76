#!/usr/bin/env python3
"""The light that leaves a half-space after each number of collisions, computed exactly. It is compared with diffusion
that starts at the first, second, third or fourth collision: the excess is shown. Scattering is isotropic, light arrives
along the normal or at an angle to it, and the boundary is a smooth dielectric. Figures are relative to the light that
enters, except in the last column, which is relative to the light that arrives. Needs NumPy.

  tools/collisions.py [ETA [DEGREES]]
"""

import sys

import numpy as np

CELLS = 600
DEEPEST = 30.0  # free paths
ALBEDOS = (0.9585, 0.838, 0.678)  # of skin1: red, green, blue


def reflectance(eta, cosine):
    """Fresnel's unpolarised reflectance, into a side that is eta times as dense."""
    squared = (1 - cosine * cosine) / (eta * eta)
    other = np.sqrt(np.maximum(1 - squared, 0))
    across = (cosine - eta * other) / (cosine + eta * other)
    along = (eta * cosine - other) / (eta * cosine + other)
    return np.where(squared >= 1, 1, (across ** 2 + along ** 2) / 2)


def directions(eta):
    """Cosines inside, their weights and reflectances, separately below and above the critical angle."""
    points, weights = np.polynomial.legendre.leggauss(64)
    critical = np.sqrt(1 - 1 / eta ** 2)
    half = (points + 1) / 2
    cosines = np.concatenate([critical * half, critical + (1 - critical) * half])
    weights = np.concatenate([critical * weights, (1 - critical) * weights]) / 2
    return cosines, weights, reflectance(1 / eta, cosines)


def transfer(edges, eta):
    """Where light from one layer collides next, by target and source layer, and how much of it leaves."""
    thick = np.diff(edges)
    below = np.tril(np.ones((CELLS, CELLS)), -1)
    apart = np.maximum(np.subtract.outer(edges[:-1], edges[1:]), 0)
    collides = np.zeros((CELLS, CELLS))
    leaves = np.zeros(CELLS)
    for cosine, weight, mirrored in zip(*directions(eta)):
        within = 1 - np.exp(-thick / cosine)
        out = cosine / thick * within  # mean over the light that reaches its own layer's edge
        between = below * np.exp(-apart / cosine)
        to_surface = out * np.exp(-edges[:-1] / cosine)
        collides += weight / 2 * np.outer(within, out) * (between + between.T)
        collides += weight / 2 * mirrored * np.outer(np.exp(-edges[:-1] / cosine) * within, to_surface)
        collides[np.diag_indices(CELLS)] += weight * (1 - out)
        leaves += weight / 2 * (1 - mirrored) * to_surface
    return collides, leaves


def grosjean(albedo):
    """The diffusion coefficient in free paths (Grosjean 1956)."""
    return (2 * (1 - albedo) + albedo) / 3


def robin(eta):
    """A in the boundary condition -D dφ/dn = φ / 2A."""
    points, weights = np.polynomial.legendre.leggauss(200)
    cosines = (points + 1) / 2
    mirrored = weights / 2 * reflectance(1 / eta, cosines) * cosines
    return (1 + 3 * (mirrored * cosines).sum()) / (1 - 2 * mirrored.sum())


def by_diffusion(albedo, eta, edges, collisions):
    """Exitance albedo φ / 2A of diffusion that starts at these collisions, with Grosjean's diffusion coefficient."""
    diffusion = grosjean(albedo)
    sigma = np.sqrt((1 - albedo) / diffusion)
    falls = -np.diff(np.exp(-sigma * edges)) / (sigma * np.diff(edges))
    fluence = (collisions * falls).sum() / (sigma * diffusion + 1 / (2 * robin(eta)))
    return albedo * fluence / (2 * robin(eta))


def main():
    eta = float(sys.argv[1]) if len(sys.argv) > 1 else 1.3
    outside = np.cos(np.radians(float(sys.argv[2]) if len(sys.argv) > 2 else 0))
    arrival = np.sqrt(1 - (1 - outside ** 2) / eta ** 2)
    enters = 1 - reflectance(eta, outside)
    edges = DEEPEST * np.linspace(0, 1, CELLS + 1) ** 2.5
    collides, leaves = transfer(edges, eta)
    print("albedo   leaves after 1, 2, 3 and more collisions   diffusion from the 1st, 2nd, 3rd, 4th over exact   of all that arrives")
    for albedo in ALBEDOS:
        collisions = [-np.diff(np.exp(-edges / arrival))]
        while collisions[-1].sum() > 1e-9:
            collisions.append(collides @ (albedo * collisions[-1]))
        orders = np.array([albedo * (leaves * each).sum() for each in collisions])
        over = [by_diffusion(albedo, eta, edges, collisions[k]) / orders[k:].sum() for k in range(4)]
        print(f"{albedo:<8} {orders[0]:.4f} {orders[1]:.4f} {orders[2:].sum():.4f}" + " " * 24 +
              " ".join(f"{each:.3f}" for each in over) + f"{enters * orders.sum():13.5f}")


if __name__ == "__main__":
    main()
