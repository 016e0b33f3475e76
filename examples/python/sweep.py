"""How absorption changes what a body looks like: sweep.png has one bear for each absorption, exitance.png a plot.
Needs Matplotlib.

    python3 sweep.py [--quick]
"""

import sys

import matplotlib.pyplot as plt
import numpy as np

import opaline

size, steps = (48, 3) if "--quick" in sys.argv else (256, 7)

jade = opaline.media()["jade"]
scene = opaline.bear(medium=jade, diagonal_mm=50)
scene.lights = [opaline.DirectionalLight((0.6, 0, -0.8), irradiance=(6, 6, 6))]  # from behind
scene.look_from((0.2, 0.1, 1))
renderer = opaline.Renderer(scene)

factors = np.geomspace(0.1, 10, steps)
pictures, means = [], []
for factor in factors:
    medium = opaline.Medium(sigma_s_prime_per_mm=jade.sigma_s_prime_per_mm,
                            sigma_a_per_mm=factor * jade.sigma_a_per_mm, eta=jade.eta)
    renderer.set_medium(0, medium)
    frame = renderer.render(size, size, aovs=["radiance", "exitance"])
    exitance = frame["exitance"]
    means.append(exitance[exitance[..., 3] > 0][:, :3].mean(axis=0))
    pictures.append(frame["radiance"])

opaline.write_png("sweep.png", np.concatenate(pictures, axis=1), exposure_stops=scene.exposure_stops,
                  background=(0.02, 0.02, 0.02))
for channel, color in enumerate(("red", "green", "blue")):
    plt.loglog(factors, np.array(means)[:, channel], "o-", color=color)
plt.xlabel("absorption, of that of jade")
plt.ylabel("mean exitance")
plt.savefig("exitance.png")
