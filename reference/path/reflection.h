#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "reference/opaque_surface.h"
#include "reference/path/random.h"
#include "reference/vector.h"

namespace opaline::reference {

/// What is mirrored of even light towards the eye, and the factor by which repeated reflection
/// between facets increases it.
struct EvenMirrored {
  Colour share{};
  double byDielectric = 0;  ///< in its strongest channel, for the part that is not metal
  Colour sentOnByDielectric{1, 1, 1};
  Colour sentOnByMetal{1, 1, 1};
};

/// The light that a surface reflects towards the eye. It is diffuse light, less what the surface
/// mirrors of even light in that direction, plus GGX with reflection between facets (Turquin 2019).
/// Light transmitted from the other side leaves diffusely, with the same reduction.
class Reflection {
 public:
  /// `normal` and the facet's normal `outside` both lie on the side of the eye.
  Reflection(const OpaqueSurface& surface, const Vector& normal, const Vector& outside,
             const Vector& toEye);
  /// The smooth or rough surface of a medium, by Fresnel's formulas, without light from inside.
  static Reflection ofMedium(double eta, double alpha, const Vector& normal, const Vector& outside,
                             const Vector& toEye);

  /// Radiance towards the eye of light that arrives diffusely on the eye's side and on the other.
  /// What facets mirror of it is left out.
  Colour ofDiffuse(const Colour& irradiance, const Colour& behind) const;
  /// Radiance towards the eye per irradiance of a surface facing the light: BRDF times cosine.
  struct Parts {
    Colour diffuse{};
    Colour mirrored{};
  };
  Parts partsOf(const Vector& toLight) const;
  Colour value(const Vector& toLight) const {
    const Parts parts = partsOf(toLight);
    return parts.diffuse + parts.mirrored;
  }
  /// Samples a direction from which light may come; density() is per steradian.
  Vector direction(Random& random) const;
  double density(const Vector& toLight) const;

 private:
  Reflection(const Vector& normal, const Vector& outside, const Vector& toEye);
  Colour fresnel(double cosine) const;
  /// Of light in the surface's frame, above it.
  Colour mirrored(const Vector& light) const;

  Vector normal_{};
  Vector outside_{};
  std::array<Vector, 2> across_{};
  Vector eye_{};  ///< in the surface's frame
  double eta_ = 0;
  double alpha_ = 1;
  double matt_ = 0;    ///< share of directions sampled for diffuse light
  double behind_ = 0;  ///< share sampled for light from the other side
  Colour diffuse_{};   ///< over π
  Colour through_{};   ///< over π
  OpaqueSurface surface_{};
  EvenMirrored even_{};
};

/// Particles that continue after one hits an opaque surface in one channel, each with full weight.
/// Their mean number is the reflectance. Calls `go` with the direction of each.
template <typename Go>
void reflectParticle(const OpaqueSurface& surface, std::size_t channel, const Vector& normal,
                     const Vector& toLight, Random& random, const Go& go);

// ---- implementation

EvenMirrored evenMirrored(const OpaqueSurface& surface, double cosine);

/// The facets' reflectance in one channel by Schlick 1994, with reflection between them towards the
/// eye.
double facetReflectance(const OpaqueSurface& surface, const EvenMirrored& even, std::size_t channel,
                        double cosine);

/// A candidate for the mirrored direction of light in a surface's frame, and the part of it that
/// facets let through.
struct MirroredCandidate {
  Vector direction{};
  double cosineHalf = 0;  ///< between light and facet
  double seen = 0;
};
MirroredCandidate mirroredCandidate(double alpha, const Vector& toLight, Random& random);

template <typename Go>
void reflectParticle(const OpaqueSurface& surface, std::size_t channel, const Vector& normal,
                     const Vector& toLight, Random& random, const Go& go) {
  const auto [x, y] = across(normal);
  const Vector light{dot(x, toLight), dot(y, toLight), dot(normal, toLight)};
  const auto send = [&, &x = x, &y = y](const Vector& v) {
    go(v[0] * x + v[1] * y + v[2] * normal);
  };
  const double cosine = std::sqrt(random());
  const Vector matt = around({0, 0, 1}, cosine, 2 * std::numbers::pi * random());
  if (random() < surface.diffuse[channel] * (1 - evenMirrored(surface, cosine).byDielectric))
    send(matt);
  if (const double through = surface.through[channel]; through > 0) {
    const double cosineBehind = std::sqrt(random());
    const Vector beyond = around({0, 0, -1}, cosineBehind, 2 * std::numbers::pi * random());
    if (random() < through * (1 - evenMirrored(surface, cosineBehind).byDielectric)) send(beyond);
  }
  if (surface.metallic <= 0 && surface.grazing <= 0 && surface.dielectric[channel] <= 0) return;
  const MirroredCandidate candidate = mirroredCandidate(surface.alpha, light, random);
  if (candidate.seen <= 0) return;
  const double share =
      candidate.seen * facetReflectance(surface, evenMirrored(surface, candidate.direction[2]),
                                        channel, candidate.cosineHalf);
  for (double left = share + random(); left >= 1; left -= 1) send(candidate.direction);
}

}  // namespace opaline::reference
