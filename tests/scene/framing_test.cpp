#include "scene/framing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace opaline::scene {
namespace {

Camera cameraAt(const Vec3& position, float fovDegrees) {
  Camera camera;
  camera.positionMm = position;
  camera.targetMm = {1, 2, 3};
  camera.verticalFovDegrees = fovDegrees;
  return camera;
}

double tangent(double degrees) {
  return std::tan(degrees * std::numbers::pi / 180);
}

TEST(Framing, OfABoxIsOfItsNearestFace) {
  for (const double aspect : {0.25, 1.0, 3.0}) {
    for (const double margin : {0.0, 0.1}) {
      Framing framing(cameraAt({1, 2, 90}, 40), aspect, margin);
      for (unsigned corner = 0; corner < 8; ++corner) {
        framing.add({1 + ((corner & 1U) != 0 ? 5.0 : -5.0), 2 + ((corner & 2U) != 0 ? 3.0 : -3.0),
                     3 + ((corner & 4U) != 0 ? 2.0 : -2.0)});
      }
      const double slope = (1 - margin) * tangent(20);
      const double expected = 2 + std::max(3 / slope, 5 / (slope * aspect));
      EXPECT_NEAR(framing.distanceMm(), expected, 1e-12 * expected) << aspect << " " << margin;
    }
  }
}

// The planes of the frustum touch it at right angles to its radius.
TEST(Framing, OfASphereTouchesTheFrustum) {
  const Camera camera = cameraAt({40, 50, -20}, 30);
  for (const double aspect : {0.5, 1.0, 2.0}) {
    Framing framing(camera, aspect, 0);
    Framing half(camera, aspect, 0);
    constexpr int steps = 400;
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j < 2 * steps; ++j) {
        const double polar = std::numbers::pi * i / steps;
        const double turn = std::numbers::pi * j / steps;
        const Double3 point{1 + 7 * std::sin(polar) * std::cos(turn), 2 + 7 * std::cos(polar),
                            3 + 7 * std::sin(polar) * std::sin(turn)};
        (j % 2 == 0 ? framing : half).add(point);
      }
    }
    framing.add(half);
    const double angle = std::atan(tangent(15) * std::min(aspect, 1.0));
    EXPECT_NEAR(framing.distanceMm(), 7 / std::sin(angle), 1e-3) << aspect;
  }
}

TEST(Framing, LooksStraightDownToo) {
  Framing framing(cameraAt({1, 50, 3}, 90), 1, 0);
  framing.add({1, 2, 8});
  EXPECT_NEAR(framing.distanceMm(), 5, 1e-12);
}

TEST(Framing, AsksForNothingWithoutPoints) {
  Framing framing(cameraAt({1, 2, 90}, 40), 1, 0);
  EXPECT_EQ(framing.distanceMm(), 0);
  framing.add({NAN, 0, 0});
  framing.add({INFINITY, 0, 0});
  EXPECT_EQ(framing.distanceMm(), 0);
}

TEST(Framing, CameraStandsBackTheWayItLooks) {
  Camera camera = cameraAt({1, 5, 7}, 40);
  standBack(camera, 10);
  EXPECT_EQ(camera.positionMm, (Vec3{1, 8, 11}));
  EXPECT_EQ(camera.targetMm, (Vec3{1, 2, 3}));
  EXPECT_EQ(distanceToTargetMm(camera), 10);
}

TEST(Framing, UsualUpIsNeverWhereTheCameraLooks) {
  EXPECT_EQ(usualUp(cameraAt({5, 6, 7}, 40)), (Vec3{0, 1, 0}));
  EXPECT_EQ(usualUp(cameraAt({1, 60, 3}, 40)), (Vec3{0, 0, -1}));
  EXPECT_EQ(usualUp(cameraAt({1, -60, 3}, 40)), (Vec3{0, 0, 1}));
}

}  // namespace
}  // namespace opaline::scene
