#pragma once

#include <functional>
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

/// Of even light, what facets mirror once towards the eye, whose reflectance depends on the cosine
/// to them alone. By a table of roughnesses and cosines.
class MirroredShare {
 public:
  explicit MirroredShare(const std::function<double(double)>& reflectance);
  double operator()(double alpha, double cosine) const;

 private:
  std::vector<double> table_;
};

/// The same of the surface of a medium, by Fresnel's formula. Kept for ever.
const MirroredShare& mirroredShareOfMedium(double eta);

/// The same of opaque surfaces: F₀ times `base` and F₉₀ times
/// `grazing`, with Fresnel's reflectance by Schlick 1994.
struct MirroredShares {
  double base = 0;
  double grazing = 0;
};
MirroredShares mirroredShares(double alpha, double cosine);

}  // namespace opaline::reference
