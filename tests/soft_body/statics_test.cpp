// Soft bodies against closed forms of the theory of elasticity.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <vector>

#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "soft_body/bodies.h"

namespace opaline {
namespace {

using namespace test;

class SoftBodyStaticsTest : public gpu::GpuTest {};

// Young's modulus over μ.
double youngOverMu(double lambda) {
  return (3 * lambda + 2) / (lambda + 1);
}

// Mean of one component over the nodes at a height.
double meanAt(const soft_body::Cage& cage, const Field& field, std::uint32_t height,
              unsigned axis) {
  double sum = 0;
  int count = 0;
  for (std::size_t n = 0; n < cage.nodes.size(); ++n)
    if (cage.nodes[n][1] == height) {
      sum += field[n][axis];
      ++count;
    }
  return sum / count;
}

// The total force that pulls the nodes above a height upwards: the hold, less the pull to rest. In
// masses of a cell · cells / substep².
double tensionAbove(SoftBodyMotion& body, const Field& shift, double reachCells, double goal,
                    double height) {
  const std::vector<double> masses = massesOf(body.cage());
  const auto grips = gpu::readAs<glm::vec4>(*gpu::sharedDevice().device, body.state().grips);
  double sum = 0;
  for (std::size_t n = 0; n < shift.size(); ++n) {
    if (body.cage().nodes[n][1] < height) continue;
    const double wanted = goal / std::sqrt(1 + goal * goal / (reachCells * reachCells));
    sum += masses[n] / 8 *
           (body.dynamics().grip * static_cast<double>(grips[n].w) * (wanted - shift[n][1]) -
            body.dynamics().anchor * shift[n][1]);
  }
  return sum;
}

// ε = F / (E A) in the middle of a bar that is held at its foot and pulled at its top.
TEST_F(SoftBodyStaticsTest, ABarStretchesByHooke) {
  const Mesh mesh = bar(3, 12);
  SoftBodyOptions options;
  options.cells = 12;
  SoftBodyMotion body(device(), mesh.positionsMm, mesh.triangles, options);
  const soft_body::Cage& cage = body.cage();
  ASSERT_EQ(cage.counts, (std::array<std::uint32_t, 3>{3, 12, 3}));
  constexpr double goalMm = 0.4;
  body.grab({0, 12, 0}, 3);
  body.pull({0, 12 + static_cast<float>(goalMm), 0});
  for (int i = 0; i < 60; ++i) body.step(0.1);
  EXPECT_FALSE(body.moves());
  const Field shift = nodesOf(body).shift;
  const double strain = (meanAt(cage, shift, 8, 1) - meanAt(cage, shift, 4, 1)) / 4;
  EXPECT_GT(strain, 0.005);
  const double reach =
      static_cast<double>(SoftBodyOptions{}.reach) * std::hypot(3.0, 12.0, 3.0) / cage.cellMm;
  const double tension = tensionAbove(body, shift, reach, goalMm / cage.cellMm, 6.5);
  constexpr double area = 9;
  const double young = tension / (area * strain) / body.dynamics().waveNumber;
  // Cells at the surface resist volume changes less, at an edge by two thirds, so the result lies
  // between both.
  EXPECT_LT(young, 1.01 * youngOverMu(soft_body::lambdaOverMu));
  EXPECT_GT(young, 0.99 * youngOverMu(soft_body::lambdaOverMu / 3));
}

// T = 4 L √(ρ / E), by times at which the top of a bar that was stretched passes its rest. In a
// substep every second layer of cells is relaxed after its neighbours, which has stretched it by
// half of what each of them gave way, so that on the mean the bar pulls back by E h² / (ρ a²) more
// than E says.
TEST_F(SoftBodyStaticsTest, ABarSwingsAlongItselfInTheTimeOfAWave) {
  const Mesh mesh = bar(2, 16);
  SoftBodyOptions options;
  options.cells = 16;
  options.settleSeconds = 20;
  SoftBodyMotion body(device(), mesh.positionsMm, mesh.triangles, options);
  const soft_body::Cage& cage = body.cage();
  std::vector<shared::SoftMotion> motions;
  for (const auto& node : cage.nodes) {
    shared::SoftMotion motion{};
    motion.shiftY = static_cast<float>(0.02 * std::sin(std::numbers::pi / 32 * node[1]));
    motion.aheadY = motion.shiftY;
    motions.push_back(motion);
  }
  body.state().motions =
      gpu::makeBuffer(device(), "stretched", motions, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  body.grab({1000, 0, 0}, 0);  // of nothing: so that it goes on
  std::vector<double> passed;
  double before = 1;
  const double h = body.dynamics().substepSeconds;
  for (int i = 1; i < 1000 && passed.size() < 5; ++i) {
    body.step(h * 1.0001);
    const double top = meanAt(cage, nodesOf(body).shift, 16, 1);
    if ((top > 0) != (before > 0)) passed.push_back(i - top / (top - before));
    before = top;
  }
  ASSERT_EQ(passed.size(), 5U);
  const double period = (passed[4] - passed[0]) / 2;  // substeps
  const auto expected = [&](double lambda) {
    const double young = youngOverMu(lambda) * body.dynamics().waveNumber;
    const double wave = 2 * std::numbers::pi / (4 * 16);
    return 2 * std::numbers::pi /
           std::sqrt(wave * wave * young * (1 + young) + body.dynamics().anchor);
  };
  EXPECT_GT(period, 0.99 * expected(soft_body::lambdaOverMu));
  EXPECT_LT(period, 1.01 * expected(soft_body::lambdaOverMu / 3));
}

}  // namespace
}  // namespace opaline
