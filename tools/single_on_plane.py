#!/usr/bin/env python3
"""Light that leaves a half-space after one collision, summed over clusters, against the exact integral. Square clusters
cover a plane in even light at a slant. Prints how much too bright the middle of a cluster is, by cluster edge in mean
free paths and by angle of arrival: mean and root mean square over 12 azimuths. The first pair is boundary transport's
method (single.comp.glsl): a cluster's own light comes from a disc where slanting rays have carried it, that of others
from points. The second takes discs for all of them. Needs NumPy.

  tools/single_on_plane.py [ETA]
"""

import sys

import numpy as np

from collisions import reflectance

GAUSS = (np.array((0.0694318442, 0.3300094782, 0.6699905218, 0.9305681558)),
         np.array((0.1739274226, 0.3260725774, 0.3260725774, 0.1739274226)))
POINTS = (np.array((0.112701665, 0.5, 0.887298335)), np.array((5, 8, 5)) / 18)
SMOOTHING = 0.9      # of squared distances, in squared radii
SOFT = 0.25          # of a disc's edge
NEAR, FAR = 0.5, 1.5  # depths in radii between which a disc turns into points


def first_points():
    """Path lengths and shares of the three points that represent light on its way in."""
    at, weights = POINTS
    paths = -2 * np.log(1 - at)
    shares = weights * np.exp(-0.5 * paths)
    return paths, shares / shares.sum()


def cone(eta):
    """Cosines inside up to the critical angle, weighted by the light that leaves."""
    critical = np.sqrt(1 - 1 / eta ** 2)
    at, weights = GAUSS
    cosines = critical + at * (1 - critical)
    return cosines, weights * (1 - critical) * (1 - reflectance(1 / eta, cosines))


def exact(eta, arrival):
    """½ ∫∫ e^{-t (1 + arrival/μ)} (1 - F) dμ dt per unit of light that entered, over paths t and cosines μ."""
    points, weights = np.polynomial.legendre.leggauss(400)
    critical = np.sqrt(1 - 1 / eta ** 2)
    cosines = critical + (points + 1) / 2 * (1 - critical)
    leaves = (1 - reflectance(1 / eta, cosines)) / (1 + arrival / cosines)
    return 0.5 * (weights / 2 * (1 - critical) * leaves).sum()


def smoothed(eta, depth, aside, radius):
    """Light of a cluster's point, averaged over both discs: μ (1 - F) e^{-z/μ} / 4r² per unit on the area π ρ²."""
    square = SMOOTHING * radius ** 2
    r = depth ** 2 + aside ** 2 + square
    cosine = np.sqrt((depth ** 2 + square) / r)
    leaves = np.where(cosine > np.sqrt(1 - 1 / eta ** 2), 1 - reflectance(1 / eta, cosine), 0)
    return radius ** 2 / 4 * np.exp(-depth / cosine) * cosine * leaves / r


def disc(eta, depth, aside, radius):
    """The same for a disc to the side: for each cone of directions the part that hits the disc."""
    total = 0
    for cosine, weight in zip(*cone(eta)):
        ring = depth * np.sqrt(1 / cosine ** 2 - 1)
        inside = np.clip(0.5 + 0.5 * (radius ** 2 - ring ** 2 - aside ** 2)
                         / (2 * ring * aside + SOFT * radius ** 2), 0, 1)
        total = total + 0.5 * weight * np.exp(-depth / cosine) * inside
    return total


def own(eta, depth, aside, radius):
    """The same for the cluster's own disc: of each cone of directions the part that meets it."""
    critical = np.sqrt(1 - 1 / eta ** 2)
    begin = max(depth / np.hypot(depth, radius + aside), critical)
    at, weights = GAUSS
    cosines = begin + at * (1 - begin)
    ring = depth * np.sqrt(1 / cosines ** 2 - 1)
    crossing = radius ** 2 - ring ** 2 - aside ** 2
    share = np.clip(0.5 + 0.5 * crossing / np.maximum(2 * ring * aside, 1e-6 * radius ** 2), 0, 1)
    return 0.5 * ((1 - begin) * weights * share * np.exp(-depth / cosines)
                  * (1 - reflectance(1 / eta, cosines))).sum()


def found(eta, arrival, edge, azimuth, displaced):
    """The sum over clusters in a square lattice."""
    radius = edge / np.sqrt(np.pi)
    at = np.arange(-40, 41) * edge
    x, y = np.meshgrid(at, at)
    across = np.sqrt(1 - arrival ** 2)
    total = 0
    for path, share in zip(*first_points()):
        depth = path * arrival
        aside = np.hypot(x + path * across * np.cos(azimuth), y + path * across * np.sin(azimuth))
        points = smoothed(eta, depth, aside, radius)
        if displaced:
            t = np.clip((depth / radius - NEAR) / (FAR - NEAR), 0, 1)
            far = t * t * (3 - 2 * t)
            points = far * points + (1 - far) * disc(eta, depth, aside, radius)
        else:
            points[40, 40] = own(eta, depth, aside[40, 40], radius)
        total += share * points.sum()
    return total


def main():
    eta = float(sys.argv[1]) if len(sys.argv) > 1 else 1.3
    print("edge    angle   own disc: mean, rms    all discs: mean, rms, %")
    for edge in (0.25, 0.5, 1, 1.5, 2, 3):
        for degrees in (0, 30, 60, 80):
            arrival = np.sqrt(1 - (np.sin(np.radians(degrees)) / eta) ** 2)
            true = exact(eta, arrival)
            row = []
            for displaced in (False, True):
                errors = [found(eta, arrival, edge, azimuth, displaced) / true - 1
                          for azimuth in np.linspace(0, np.pi / 4, 12)]
                row += [100 * np.mean(errors), 100 * np.sqrt(np.mean(np.square(errors)))]
            print(f"{edge:4.2f}  {degrees:5}°  {row[0]:+18.1f} {row[1]:6.1f}  {row[2]:+18.1f} {row[3]:6.1f}")


if __name__ == "__main__":
    main()
