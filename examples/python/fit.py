"""Finds the absorption of a body from a picture of it, and writes what was found beside what was given: fit.png.
Needs SciPy.

    python3 fit.py [--quick]
"""

import sys

import numpy as np
from scipy.optimize import least_squares

import opaline

size = 24 if "--quick" in sys.argv else 96

scattering, hidden = (1.4, 1.5, 1.6), np.array([0.004, 0.02, 0.09])


def medium(absorption):
    return opaline.Medium(sigma_s_prime_per_mm=scattering, sigma_a_per_mm=absorption, eta=1.4)


scene = opaline.teapot(medium=medium(hidden), diagonal_mm=60)
scene.lights = [opaline.DirectionalLight((0.6, 0.3, -0.7), irradiance=(5, 5, 5))]
renderer = opaline.Renderer(scene)


def draw(absorption):
    renderer.set_medium(0, medium(absorption))
    return renderer.render(size, size, "exitance", transport="dipole")["exitance"]


given = draw(hidden)
body = given[..., 3] > 0


def difference(logarithms):
    """The difference from the given picture of a body with that absorption, in every pixel and channel."""
    return (draw(np.exp(logarithms)) - given)[body][:, :3].ravel()


# Logarithms keep absorption positive. Steps of 2 % show how the picture depends on it.
fit = least_squares(difference, np.log([0.03, 0.03, 0.03]), diff_step=0.02)
found = np.exp(fit.x)
print(f"found {np.round(found, 5)}, hidden {hidden}, off by {np.abs(found / hidden - 1).max():.2%}, {fit.nfev} steps")
opaline.write_png("fit.png", np.concatenate([given, draw(found)], axis=1), background=(0, 0, 0))
assert np.abs(found / hidden - 1).max() < 0.05
