// Energy after a hard pull, by the formulas of continuum mechanics instead of the shader's.

#include <gtest/gtest.h>

#include <vector>

#include "gpu/gpu_fixture.h"
#include "soft_body/bodies.h"

namespace opaline {
namespace {

using namespace test;

class SoftBodyEnergyTest : public gpu::GpuTest, public testing::WithParamInterface<double> {};

// Pulled sideways and up by several tenths of the diagonal, then released. There is almost no
// damping that could hide an increase.
TEST_P(SoftBodyEnergyTest, NeverGrowsAfterRelease) {
  const double callsPerSecond = GetParam();
  const Scene scene = builtInBear();
  const Mesh& mesh = scene.objects[0].mesh;
  SoftBodyOptions options;
  options.settleSeconds = 60;
  SoftBodyMotion body(device(), mesh.positionsMm, mesh.triangles, options);
  body.grab({0, 39, 0}, 4);
  body.pull({22, 55, 10});
  for (int i = 0; i < 20; ++i) body.step(0.1);
  body.release();
  body.step(body.dynamics().substepSeconds * 1.5);  // the hold no longer does work
  double energy = energyOf(body);
  const double first = energy;
  EXPECT_GT(first, 0);
  const int calls = callsPerSecond > 100 ? 240 : 40;
  for (int i = 0; i < calls; ++i) {
    body.step(1 / callsPerSecond);
    const double next = energyOf(body);
    ASSERT_LE(next, energy + 1e-6 * first) << i;
    energy = next;
  }
  EXPECT_LT(energy, 0.5 * first);
}

INSTANTIATE_TEST_SUITE_P(FrameRates, SoftBodyEnergyTest, testing::Values(10.0, 240.0));

}  // namespace
}  // namespace opaline
