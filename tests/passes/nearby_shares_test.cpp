// What sums over coarse sources miss, against sums over lattices of sources.

#include "passes/scatter/nearby_shares.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "bssrdf/profile.h"
#include "opaline/medium.h"
#include "shaders/shared/nearby.h"

namespace opaline::passes {
namespace {

// The shaders' sum over a square lattice of sources in unit irradiance, at a place within one of
// its squares.
double latticeSum(const bssrdf::Profile& profile, double spacingMm, std::array<double, 2> place) {
  const double reachMm = static_cast<double>(shared::reachInSpacings) * spacingMm;
  const int cells = static_cast<int>(std::ceil(20 / (profile.sigmaTrPerMm * spacingMm))) + 6;
  double sum = 0;
  for (int j = -cells; j <= cells; ++j)
    for (int i = -cells; i <= cells; ++i) {
      const double inReaches = std::hypot(i + place[0], j + place[1]) * spacingMm / reachMm;
      const auto squared = static_cast<float>(inReaches * inReaches);
      sum += profile(reachMm * std::sqrt(static_cast<double>(shared::smoothedSquare(squared, 1))));
    }
  return sum * spacingMm * spacingMm;
}

TEST(NearbyShares, MakeUpForWhatALatticeLacks) {
  const Medium medium{.sigmaSPrimePerMm = {2.19, 0.74, 0.18}, .sigmaAPerMm = {0.02, 0.03, 0.061}};
  for (const bssrdf::Model model : {bssrdf::Model::Dipole, bssrdf::Model::BetterDipole})
    for (int channel = 0; channel < 3; ++channel) {
      const bssrdf::Coefficients coefficients = bssrdf::coefficients(medium, channel);
      const bssrdf::Profile profile = bssrdf::makeProfile(model, coefficients);
      double lastAll = 0;
      for (const double inFreePaths : {0.8, 1.5, 4.0, 20.0, 1000.0}) {
        const double spacingMm = inFreePaths * coefficients.meanFreePathMm;
        const NearbyShares shares =
            nearbyShares(profile, static_cast<double>(shared::reachInSpacings) * spacingMm);
        EXPECT_GE(shares.disc, 0);
        EXPECT_GE(shares.innerRing, 0);
        EXPECT_GE(shares.outerRing, 0);
        const double all = shares.disc + shares.innerRing + shares.outerRing;
        EXPECT_GT(all, lastAll);
        lastAll = all;
        for (const std::array<double, 2> place :
             {std::array{0.0, 0.0}, std::array{0.5, 0.5}, std::array{0.25, 0.1}})
          EXPECT_NEAR(latticeSum(profile, spacingMm, place) + all, profile.totalReflectance(),
                      5e-4 * profile.totalReflectance())
              << channel << " " << inFreePaths;
      }
      EXPECT_NEAR(lastAll, profile.totalReflectance(), 1e-3 * profile.totalReflectance());
    }
}

}  // namespace
}  // namespace opaline::passes
