#pragma once

#include "bssrdf/profile.h"

namespace opaline::passes {

/// What sums over coarse sources lack on a plane in even light, within a disc and two rings
/// (shaders/shared/nearby.h), as parts of the irradiance.
struct NearbyShares {
  double disc = 0;
  double innerRing = 0;
  double outerRing = 0;
  double kept = 0;  ///< what the sums contain, by shared::nearbyWeight
};

/// `reachMm` > 0.
NearbyShares nearbyShares(const bssrdf::Profile& profile, double reachMm);

}  // namespace opaline::passes
