// Absorbing layers on a medium, against exact transfer in a half-space and closed forms.

#include "bssrdf/paint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bssrdf/fresnel.h"
#include "bssrdf/half_space.h"
#include "bssrdf/profile.h"

namespace opaline::bssrdf {
namespace {

using test::HalfSpace;

Medium mediumOfAlbedo(double albedo, double eta) {
  return {"", {albedo, albedo, albedo}, {1 - albedo, 1 - albedo, 1 - albedo}, eta};
}

TEST(PaintTest, TheOracleKnowsWhatIsWhite) {
  EXPECT_NEAR(HalfSpace(1 - 1e-9, 1.4).ofEvenLight(0), 1, 2e-3);
  EXPECT_NEAR(HalfSpace(1 - 1e-9, 1.4).ofBeam(0, 0.9), 1, 2e-3);
}

TEST(PaintTest, WithoutALayerNothingChanges) {
  for (const double eta : {1.01, 1.3, 1.5, 2.0}) {
    const PaintedBoundary bare = paintedBoundary(eta, 0);
    EXPECT_NEAR(bare.entering, 1, 1e-12);
    EXPECT_NEAR(bare.layer, 1, 1e-12);
    EXPECT_NEAR(bare.leaving, 1, 1e-4);
    // M = φ/2A - (κ - 1)E.
    EXPECT_NEAR(bare.source - bare.takenOff, 1, 1e-4);
  }
}

// What a medium of that colour returns of even light, with a layer and without.
TEST(PaintTest, LayersGiveTheColorsThatTheyAreFor) {
  for (const double eta : {1.3, 1.4, 1.5})
    for (const double albedo : {0.9995, 0.99, 0.95}) {
      const HalfSpace exact(albedo, eta);
      const double bare = exact.ofEvenLight(0);
      const auto layers = paints(mediumOfAlbedo(albedo, eta), 65)[0];
      for (std::size_t i = 1; i < layers.size(); i += 4) {
        const double wanted = std::pow(static_cast<double>(i) / 64, 2);
        EXPECT_NEAR(exact.ofEvenLight(layers[i].thickness) / bare, wanted, 0.012)
            << eta << " " << albedo;
      }
    }
}

// Diffusion with a scaled source at a depth, against a beam. On a plane the fluence at the surface
// is S / (√(σ_a D) + 1/2A') for any source S.
TEST(PaintTest, LightFromADepthLeavesAsMuchAsInAHalfSpace) {
  for (const double eta : {1.3, 1.4, 1.5})
    for (const double albedo : {0.9995, 0.99, 0.95}) {
      const Medium medium = mediumOfAlbedo(albedo, eta);
      const HalfSpace exact(albedo, eta);
      const Profile profile = makeProfiles(Model::BetterDipole, medium)[0];
      const double taken = profile.diffusionMm * profile.sigmaTrPerMm;
      const double overTwoA = (1 - twoC1(eta)) / (1 + threeC2(eta)) / 2;
      const auto layers = paints(medium, 65)[0];
      const auto leaves = [&](const PaintedBoundary& layer) {
        return layer.deep * layer.leaving / (taken + layer.layer * overTwoA);
      };
      for (std::size_t i = 12; i < layers.size(); i += 4) {
        const double thickness = layers[i].thickness;
        for (const double cosine : {1.0, 0.85}) {
          const double wanted = exact.ofBeam(thickness, cosine) / exact.ofBeam(0, cosine) /
                                std::exp(-thickness / cosine);
          EXPECT_NEAR(leaves(layers[i]) / leaves(layers.back()) / wanted, 1, 0.035)
              << eta << " " << albedo << " " << thickness << " " << cosine;
        }
      }
    }
}

TEST(PaintTest, ColorsOfMediaAreThoseTheyWereMadeFor) {
  const Appearance appearance{{0.9, 0.5, 0.1}, {1, 2, 3}, 0, 1.4};
  const Rgb color = colorOf(mediumOf(appearance));
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(color[c], appearance.color[c], 1e-6);
}

}  // namespace
}  // namespace opaline::bssrdf
