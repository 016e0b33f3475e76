"""Finds the absorption of a body from a picture of it, and writes what was found beside what was given: fit.png.

    python3 fit.py [--quick]
"""

import sys

import numpy as np

import opaline

size, rounds = (24, 4) if "--quick" in sys.argv else (96, 8)

scattering, hidden = (1.4, 1.5, 1.6), np.array([0.004, 0.02, 0.09])


def medium(absorption):
    return opaline.Medium(sigma_s_prime_per_mm=scattering, sigma_a_per_mm=absorption, eta=1.4)


scene = opaline.teapot(medium=medium(hidden), diagonal_mm=60)
scene.lights = [opaline.DirectionalLight((0.6, 0.3, -0.7), irradiance=(5, 5, 5))]
renderer = opaline.Renderer(scene)


def brightness(absorption):
    """The mean of each channel; they do not depend on each other."""
    renderer.set_medium(0, medium(absorption))
    picture = renderer.render(size, size, "exitance", transport="dipole")["exitance"]
    return picture[picture[..., 3] > 0][:, :3].mean(axis=0), picture


wanted, given = brightness(hidden)

# The more a body absorbs, the darker it is: the secant method on logarithms, for all three channels at once.
before, now = np.full(3, np.log(0.01)), np.full(3, np.log(0.03))
error_before = np.log(brightness(np.exp(before))[0] / wanted)
for number in range(rounds):
    brightnesses, picture = brightness(np.exp(now))
    error = np.log(brightnesses / wanted)
    print(f"round {number}: absorption {np.round(np.exp(now), 5)}, brightness off by {np.abs(error).max():.2%}")
    slope = (error - error_before) / np.where(now == before, 1, now - before)
    step = np.where(np.abs(slope) > 1e-6, -error / slope, 0)
    before, error_before, now = now, error, now + np.clip(step, -1.5, 1.5)

found = np.exp(now)
print(f"found {np.round(found, 5)}, hidden {hidden}, off by {np.abs(found / hidden - 1).max():.2%}")
opaline.write_png("fit.png", np.concatenate([given, brightness(found)[1]], axis=1), background=(0, 0, 0))
assert np.abs(found / hidden - 1).max() < 0.05
