"""The medium that looks as Cycles' subsurface scattering does.

Cycles (4.0, src/kernel/closure/bssrdf.h and src/kernel/integrator/subsurface_random_walk.h) makes of a radius and a colour A
first a mean free path l, then the coefficients of its random walk:

- Burley, and Random Walk with a fixed radius: l = radius / (4 pi).
- Random Walk of 3.x, Random Walk (Skin) of 4.x: l = radius sqrt(3 (1 - a')), where a' is the reduced albedo of which the
  dipole of Jensen et al. 2001 reflects A, with the internal reflection of the index of refraction.
- The walk's single-scattering albedo is the fit of Wrenninge et al. 2017 to A and the mean cosine g, and its extinction is
  1 / (l (1 - g)).

From 4.0 on Random Walk starts along the view, refracted at a rough surface (GGX), so that what is seen of A depends on it: by
R(mu) = 1 - sqrt(1 - a) H(mu) of a half-space (Chandrasekhar 1960). We take the mean over views, weighted by their cosines.

That walk has no boundary with Fresnel's reflection, which our media have. So we take what is seen of it: the medium gives
back the same colour A in even light, and light spreads as far in it: its diffusion length is that of the walk."""

import functools
import math

import numpy as np

FIXED = "fixed"  # the radius is a mean free path, up to a factor
ALONG_VIEW = "along view"  # as FIXED, for a walk that starts along the view
ADJUSTED = "adjusted"  # the radius is a diffusion length, by the dipole

# No real material is beyond these. There the fit's logarithms and the medium's coefficients fail.
LEAST_COLOR, MOST_COLOR = 0.005, 0.99
MOST_ETA = 1.6  # limit of the fit from colours to media

LEAST_ALBEDO, MOST_ALBEDO = 0.2, 0.999999  # of Cycles' walk


def kind_of(method):
    """The kind for Blender's name of a method. RANDOM_WALK has different meanings in 3.x and 4.x."""
    import bpy

    if bpy.app.version >= (4, 0, 0):
        return {"RANDOM_WALK_SKIN": ADJUSTED, "RANDOM_WALK": ALONG_VIEW}.get(method, FIXED)
    return ADJUSTED if method == "RANDOM_WALK" else FIXED


def dipole_reflectance(reduced_albedo, four_thirds_a):
    """Jensen et al. 2001, Eq. 15."""
    s = math.sqrt(3 * (1 - reduced_albedo))
    return 0.5 * reduced_albedo * (1 + math.exp(-four_thirds_a * s)) * math.exp(-s)


def reduced_albedo_of(color, eta):
    """The inverse, computed as in Cycles."""
    if color < 1e-4:
        return 0.0
    if color >= 0.995:
        return 0.999999
    inverse = 1 / eta
    reflected = inverse * (-1.440 * inverse + 0.710) + 0.668 + 0.0636 * eta
    four_thirds_a = 4 / 3 * (1 + reflected) / (1 - reflected)
    low, high = 0.0, 1.0
    for _ in range(40):
        middle = (low + high) / 2
        if dipole_reflectance(middle, four_thirds_a) < color:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def mean_free_path(radius, color, kind, eta):
    """The mean free path of the reduced medium, in the radius' unit."""
    if kind == ADJUSTED:
        return radius * math.sqrt(3 * (1 - reduced_albedo_of(color, eta)))
    return radius / (4 * math.pi)


def walk_albedo(color, g):
    """Single-scattering albedo of Cycles' walk (Wrenninge et al. 2017)."""
    powers = g ** np.arange(8)

    def polynomial(*coefficients):
        return float(np.dot(powers, coefficients))

    a = polynomial(1.8260523782, -1.28451056436, -1.79904629312, 9.19393289202, -22.8215585862, 32.0234874259, -23.6264803333,
                   7.21067002658)
    b = 4.98511194385 + 0.127355959438 * math.exp(polynomial(0, 31.1491581433, -201.847017512, 841.576016723, -2018.09288505,
                                                             2731.71560286, -1935.41424244, 559.009054474))
    c = polynomial(1.09686102424, -0.394704063468, 1.05258115941, -8.83963712726, 28.8643230661, -46.8802913581, 38.5402837518,
                   -12.7181042538)
    d = polynomial(0.496310210422, 0.360146581622, -2.15139309747, 17.8896899217, -55.2984010333, 82.065982243, -58.5106008578,
                   15.8478295021)
    e = 4.23190299701 + 0.00310603949088 * math.exp(polynomial(0, 76.7316253952, -594.356773233, 2448.8834203, -5576.68528998,
                                                               7116.60171912, -4763.54467887, 1303.5318055))
    f = polynomial(2.40602999408, -2.51814844609, 9.18494908356, -79.2191708682, 259.082868209, -403.613804597, 302.85712436,
                   -87.4370473567)
    blend = color ** 0.25
    albedo = (1 - blend) * a * math.atan(b * color) ** c + blend * d * math.atan(e * color) ** f
    return min(max(albedo, LEAST_ALBEDO), MOST_ALBEDO)


def diffusion_length(reduced_scattering, absorption):
    """1/sigma_tr, in the coefficients' unit."""
    return 1 / np.sqrt(3 * absorption * (absorption + reduced_scattering))


def walk_length(radius, color, kind, eta, g):
    """How far light spreads in Cycles' walk: its diffusion length, in the radius' unit."""
    extinction = 1 / (mean_free_path(radius, color, kind, eta) * (1 - g))
    albedo = walk_albedo(color, g)
    return float(diffusion_length(albedo * extinction * (1 - g), (1 - albedo) * extinction))


def reflectance_of(albedo):
    """The reflectance of a half-space with isotropic scattering, as a function of the cosines at which light starts."""
    at, weights = (values / 2 for values in np.polynomial.legendre.leggauss(32))
    at = at + 0.5
    absorbed = math.sqrt(1 - albedo)

    def h_functions(values, where):  # Chandrasekhar 1960, Eq. V.33
        return 1 / (absorbed + albedo / 2 * (at * values * weights / (where[:, None] + at)).sum(axis=1))

    values = np.ones_like(at)
    for _ in range(1000):
        before, values = values, h_functions(values, at)
        if np.abs(values - before).max() < 1e-6:
            break
    return lambda cosines: 1 - absorbed * h_functions(values, cosines)


def refracted(cosine, eta, alpha, count=16):
    """Cosines inside for a view through the GGX microfacets that it sees (Heitz 2018)."""
    u, v = (part.ravel() for part in np.meshgrid(*2 * [(np.arange(count) + 0.5) / count]))
    view = np.array((math.sqrt(1 - cosine * cosine), 0, cosine))
    stretched = np.array((alpha * view[0], 0, view[2]))
    stretched /= np.linalg.norm(stretched)
    along = np.array((stretched[2], 0, -stretched[0]))
    a, b = np.sqrt(u) * np.cos(2 * math.pi * v), np.sqrt(u) * np.sin(2 * math.pi * v)
    part = (1 + stretched[2]) / 2
    b = (1 - part) * np.sqrt(1 - a * a) + part * b
    normal = np.outer(a, (0, 1, 0)) + np.outer(b, -along) + np.outer(np.sqrt(np.maximum(1 - a * a - b * b, 0)), stretched)
    normal = normal * (alpha, alpha, 1)
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    towards = normal @ view
    inside = view[2] / eta - (towards / eta - np.sqrt(1 - (1 - towards * towards) / (eta * eta))) * normal[:, 2]
    return inside[inside > 0]


@functools.lru_cache(maxsize=64)
def seen_in_mean(color, eta, g, roughness):
    """The colour of a walk that starts along the view: the mean over views."""
    albedo = walk_albedo(color, g)
    reflectance = reflectance_of(albedo * (1 - g) / (1 - albedo * g))  # as if scattering were isotropic
    squares, weights = np.polynomial.legendre.leggauss(8)
    return sum(weight / 2 * float(reflectance(refracted(math.sqrt((square + 1) / 2), eta, roughness ** 2)).mean())
               for square, weight in zip(squares, weights))


def medium_of(radius_mm, color, kind, eta=1.4, g=0.0, surface_eta=1.5, roughness=0.5):
    """opaline.Medium for red, green and blue. eta is the method's index of refraction, surface_eta the body's. The
    roughness only matters for ALONG_VIEW."""
    import opaline

    color = np.clip(np.asarray(color, dtype=float)[:3], LEAST_COLOR, MOST_COLOR)
    radius = np.clip(np.asarray(radius_mm, dtype=float), 1e-4, 1e4)
    g = min(max(g, 0.0), 0.9)
    surface_eta = min(max(surface_eta, 1.01), MOST_ETA)
    seen = color
    if kind == ALONG_VIEW:
        seen = np.array([seen_in_mean(float(a), surface_eta, g, max(float(roughness), 1e-2)) for a in color])
        seen = np.clip(seen, LEAST_COLOR, MOST_COLOR)
    unit = opaline.Medium.from_appearance(seen, (1, 1, 1), g, surface_eta)
    length = diffusion_length(unit.sigma_s_prime_per_mm, np.maximum(unit.sigma_a_per_mm, 1e-12))
    wanted = np.array([walk_length(r, a, kind, min(max(eta, 1.01), 3.8), g) for r, a in zip(radius, color)])
    return opaline.Medium.from_appearance(seen, np.clip(wanted / length, 1e-6, 1e6), g, surface_eta)
