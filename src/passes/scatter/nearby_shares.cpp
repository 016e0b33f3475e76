#include "passes/scatter/nearby_shares.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shaders/shared/nearby.h"

namespace opaline::passes {

namespace {

// The integral of the smoothed profile over the ring between two radii, mm, by Simpson's rule. The
// profile has no detail much narrower than the reach.
template <typename Weight>
double smoothedRing(const bssrdf::Profile& profile, double reachMm, double fromMm, double toMm,
                    const Weight& weightOf) {
  constexpr int steps = 64;
  const double stepMm = (toMm - fromMm) / steps;
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const double rule = i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2;
    const double r = fromMm + i * stepMm;
    const auto squared = static_cast<float>(r * r / (reachMm * reachMm));
    const double smoothedMm =
        reachMm * std::sqrt(static_cast<double>(shared::smoothedSquare(squared, 1)));
    sum += rule * static_cast<double>(weightOf(squared)) * r * profile(smoothedMm);
  }
  return 2 * std::numbers::pi * sum * stepMm / 3;
}

}  // namespace

NearbyShares nearbyShares(const bssrdf::Profile& profile, double reachMm) {
  const double discMm = static_cast<double>(shared::discInReaches) * reachMm;
  const double innerMm = static_cast<double>(shared::innerRingInReaches) * reachMm;
  const auto lacking = [&](double fromMm, double toMm) {
    const double exact = profile.disc(toMm) - profile.disc(fromMm);
    return std::max(
        exact - smoothedRing(profile, reachMm, fromMm, toMm, [](float) { return 1.0F; }), 0.0);
  };
  return {lacking(0, discMm), lacking(discMm, innerMm), lacking(innerMm, reachMm),
          smoothedRing(profile, reachMm, 0, reachMm,
                       [](float squared) { return shared::nearbyWeight(squared, 1); })};
}

}  // namespace opaline::passes
