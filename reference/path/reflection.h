#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "reference/opaque_surface.h"
#include "reference/path/random.h"
#include "reference/vector.h"

namespace opaline::reference {

/// Towards the eye, of even light: what is mirrored, and how much more that is than facets mirror
/// once.
struct EvenMirrored {
  Colour share{};
  double byDielectric = 0;  ///< in its strongest channel, of light that falls on what is no metal
  Colour sentOnByDielectric{1, 1, 1};
  Colour sentOnByMetal{1, 1, 1};
};

/// What a surface reflects towards the eye: light that it gives back diffusely, less by what it
/// mirrors of even light towards there, and GGX with what facets send on to each other (Turquin
/// 2019). Light of the other side that gets through leaves diffusely, less by the same.
class Reflection {
 public:
  /// `normal` on the side of the eye; `outside` is the facet's, on that side as well.
  Reflection(const OpaqueSurface& surface, const Vector& normal, const Vector& outside,
             const Vector& toEye);
  /// The smooth or rough surface of a medium, by Fresnel's formulas, without what leaves it.
  static Reflection ofMedium(double eta, double alpha, const Vector& normal, const Vector& outside,
                             const Vector& toEye);

  /// Radiance towards the eye per irradiance of a surface that faces the light: BRDF and cosine.
  Colour value(const Vector& toLight) const;
  /// A direction that light may come from, and how dense they are, per steradian.
  Vector direction(Random& random) const;
  double density(const Vector& toLight) const;

 private:
  Reflection(const Vector& normal, const Vector& outside, const Vector& toEye);
  Colour fresnel(double cosine) const;

  Vector normal_{};
  Vector outside_{};
  std::array<Vector, 2> across_{};
  Vector eye_{};  ///< in the surface's frame
  double eta_ = 0;
  double alpha_ = 1;
  double matt_ = 0;    ///< share of directions that are chosen for diffuse light
  double behind_ = 0;  ///< and for light of the other side
  Colour diffuse_{};   ///< over π
  Colour through_{};   ///< over π
  OpaqueSurface surface_{};
  EvenMirrored even_{};
};

/// Of light that meets an opaque surface in one channel, the particles that go on, each with all
/// its weight: as many in the mean as it reflects. Calls `go` with the direction of each.
template <typename Go>
void reflectParticle(const OpaqueSurface& surface, std::size_t channel, const Vector& normal,
                     const Vector& toLight, Random& random, const Go& go);

// ---- implementation

EvenMirrored evenMirrored(const OpaqueSurface& surface, double cosine);

/// Of facets in one channel, by Schlick 1994, with what they send on to each other towards the eye.
double facetReflectance(const OpaqueSurface& surface, const EvenMirrored& even, std::size_t channel,
                        double cosine);

/// Candidate of the mirrored direction of light, in the frame of a surface, and the part of it that
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
