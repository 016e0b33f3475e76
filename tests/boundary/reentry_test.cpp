#include "boundary/reentry.h"

#include <gtest/gtest.h>

#include "boundary/bodies.h"

namespace opaline::test::boundary {
namespace {

TEST(Reentry, NothingOfAConvexBodyMeetsItAgain) {
  const ClusteredBody body = sphere(5, 2);
  const reference::Geometry geometry(body.scene);
  const TriangleClusters clusters = clustersOf(geometry, body.clusterOfTriangle);
  const Diffusion medium({1, 0.1, 1.3});
  EXPECT_EQ(Reentry::ofPairs(geometry, clusters, medium).entries(), 0U);
  EXPECT_EQ(Reentry::ofSpreadRays(geometry, clusters, medium, 16).entries(), 0U);
}

// In a hollow sphere light leaves and arrives at the same angle: E' = M 2∫F_t² μ dμ / F̄_t.
TEST(Reentry, InAHollowAllOfItDoes) {
  const ClusteredBody body = hollowSphere(10, 6, 3);
  const reference::Geometry geometry(body.scene);
  const TriangleClusters clusters = clustersOf(geometry, body.clusterOfTriangle);
  const Diffusion medium({1, 0.1, 1.5});
  constexpr int steps = 10000;
  double expected = 0;
  for (int k = 0; k < steps; ++k) {
    const double cosine = (k + 0.5) / steps;
    const double through = 1 - reflectanceOutside(1.5, cosine);
    expected += 2 * through * through * cosine / (steps * medium.meanTransmittance);
  }
  const std::vector<double> exitance(clusters.count(), 1);
  const auto meanInside = [&](const Reentry& reentry) {
    const std::vector<double> entering = reentry.entering(exitance);
    const std::size_t half = clusters.count() / 2;
    double flux = 0;
    double area = 0;
    for (std::size_t i = half; i < clusters.count(); ++i) {
      flux += entering[i] * clusters.list[i].areaMm2;
      area += clusters.list[i].areaMm2;
      EXPECT_EQ(entering[i - half], 0);
    }
    return flux / area;
  };
  EXPECT_NEAR(meanInside(Reentry::ofSpreadRays(geometry, clusters, medium, 64)) / expected, 1,
              0.01);
  EXPECT_NEAR(meanInside(Reentry::ofRays(geometry, clusters, medium, 64)) / expected, 1, 0.01);
  EXPECT_NEAR(meanInside(Reentry::ofPairs(geometry, clusters, medium)) / expected, 1, 0.05);
}

}  // namespace
}  // namespace opaline::test::boundary
