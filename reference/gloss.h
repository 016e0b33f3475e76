#pragma once

#include <functional>
#include <vector>

#include "reference/vector.h"

namespace opaline::reference {

/// The GGX distribution of microfacets (Walter et al. 2007), α = roughness², per steradian.
double ggxDensity(double alpha, double cosineHalf);

/// Smith's Λ of that distribution. From a direction, the share 1 / (1 + Λ) of the facets that face
/// it is visible.
double ggxHidden(double alpha, double cosine);

/// A normal among those visible from `toEye`, for two uniform numbers in (0, 1) (Heitz 2018). All
/// vectors are in the surface's frame, with its normal as the z axis.
Vector visibleFacet(double alpha, const Vector& toEye, double u1, double u2);

/// The share of even light that facets mirror once towards the eye, where reflectance only depends
/// on the cosine to the facet. Tabulated over roughnesses and cosines.
class MirroredShare {
 public:
  explicit MirroredShare(const std::function<double(double)>& reflectance);
  double operator()(double alpha, double cosine) const;

 private:
  std::vector<double> table_;
};

/// The same for the surface of a medium, by Fresnel's formula. The table is kept for ever.
const MirroredShare& mirroredShareOfMedium(double eta);

/// The same for opaque surfaces, with Fresnel's reflectance by Schlick 1994: the share is F₀ times
/// `base` plus F₉₀ times `grazing`.
struct MirroredShares {
  double base = 0;
  double grazing = 0;
};
MirroredShares mirroredShares(double alpha, double cosine);

}  // namespace opaline::reference
