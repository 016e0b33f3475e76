#pragma once

#include <vector>

#include "reference/vector.h"

namespace opaline::reference {

/// The GGX distribution of microfacets (Walter et al. 2007), α = roughness², per steradian.
double ggxDensity(double alpha, double cosineHalf);

/// Smith's Λ of it: a direction sees the share 1 / (1 + Λ) of the facets that face it.
double ggxHidden(double alpha, double cosine);

/// A normal among those that are seen from `toEye`, for two even numbers in (0, 1) (Heitz 2018).
/// All in the surface's frame, with the z axis as its normal.
Vector visibleFacet(double alpha, const Vector& toEye, double u1, double u2);

/// Of even light, what facets mirror once towards the eye: F₀ times `base` and F₉₀ times
/// `grazing`, with Fresnel's reflectance by Schlick 1994.
struct MirroredShares {
  double base = 0;
  double grazing = 0;
};
MirroredShares mirroredShares(double alpha, double cosine);

/// Of even light, what the surface of a medium mirrors once towards the eye, with Fresnel's
/// formula.
class MediumMirror {
 public:
  MediumMirror(double eta, double alpha);
  double share(double cosine) const;

 private:
  std::vector<double> table_;  ///< by the cosine
};

}  // namespace opaline::reference
