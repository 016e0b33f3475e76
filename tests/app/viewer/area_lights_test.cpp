#include "viewer/session/area_lights.h"

#include <gtest/gtest.h>

#include <cmath>

namespace opaline::app::viewer {
namespace {

void expectNear(const Vec3& value, const Vec3& expected) {
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(value[axis], expected[axis], 1e-4);
}

// From the front to the right side: what was to the right is now to the back, and up stays up.
TEST(AreaLights, ARectangleTurnsAboutTheVertical) {
  RectangleLight light{{1, 2, 3}, {10, 0, 0}, {0, 20, 0}, {1, 1, 1}};
  turnTo({1, 0, 0}, light);
  expectNear(light.centreMm, {1, 2, 3});
  expectNear(light.uMm, {0, 0, -10});
  expectNear(light.vMm, {0, 20, 0});
}

// From the front down: what was up is now to the front.
TEST(AreaLights, ARectangleTurnsAboutTheLevelLineInIt) {
  RectangleLight light{{}, {10, 0, 0}, {0, 20, 0}, {1, 1, 1}};
  turnTo({0, -1, 0}, light);
  expectNear(light.uMm, {10, 0, 0});
  expectNear(light.vMm, {0, 0, 20});
}

// About other axes it would come back rolled about its normal.
TEST(AreaLights, ARectangleThatIsTurnedBackIsWhatItWas) {
  const RectangleLight before{{}, {10, 3, 0}, {-1, 20, 4}, {1, 1, 1}};
  RectangleLight light = before;
  const auto s = static_cast<float>(std::sqrt(0.5));
  for (const glm::vec3 normal : {glm::vec3(s, -s, 0), glm::vec3(0, s, -s), glm::vec3(-s, 0, s)})
    turnTo(normal, light);
  turnTo(normalOf(before), light);
  expectNear(light.uMm, before.uMm);
  expectNear(light.vMm, before.vMm);
}

// u and v are half of the edges.
TEST(AreaLights, ARectanglesEdgesAreAsLongAsSaidAndKeepTheirDirections) {
  RectangleLight light{{}, {3, 4, 0}, {0, 0, 6}, {1, 1, 1}};
  EXPECT_FLOAT_EQ(edgesMm(light).x, 10);
  EXPECT_FLOAT_EQ(edgesMm(light).y, 12);
  for (int frame = 0; frame < 3; ++frame) setEdges({20, 4}, light);  // held over some frames
  expectNear(light.uMm, {6, 8, 0});
  expectNear(light.vMm, {0, 0, 2});
}

}  // namespace
}  // namespace opaline::app::viewer
