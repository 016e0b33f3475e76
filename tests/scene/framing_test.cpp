#include "opaline/framing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "opaline/error.h"

namespace opaline {
namespace {

Camera cameraAt(const Vec3& position, float fovDegrees) {
  Camera camera;
  camera.positionMm = position;
  camera.targetMm = {1, 2, 3};
  camera.verticalFovDegrees = fovDegrees;
  return camera;
}

double distanceOf(const Framing& framing) {
  return distanceToTargetMm(framing.camera());
}

double tangent(double degrees) {
  return std::tan(degrees * std::numbers::pi / 180);
}

TEST(Framing, OfABoxIsOfItsNearestFace) {
  for (const double aspect : {0.25, 1.0, 3.0}) {
    for (const double margin : {0.0, 0.1}) {
      Framing framing(cameraAt({1, 2, 90}, 40), aspect, margin);
      for (unsigned corner = 0; corner < 8; ++corner) {
        framing.add({(corner & 1U) != 0 ? 6.0F : -4.0F, (corner & 2U) != 0 ? 5.0F : -1.0F,
                     (corner & 4U) != 0 ? 5.0F : 1.0F});
      }
      const double slope = (1 - margin) * tangent(20);
      const double expected = 2 + std::max(3 / slope, 5 / (slope * aspect));
      EXPECT_NEAR(distanceOf(framing), expected, 1e-6 * expected) << aspect << " " << margin;
    }
  }
}

// The frustum's planes touch the sphere at right angles to its radius.
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
        const Vec3 point{static_cast<float>(1 + 7 * std::sin(polar) * std::cos(turn)),
                         static_cast<float>(2 + 7 * std::cos(polar)),
                         static_cast<float>(3 + 7 * std::sin(polar) * std::sin(turn))};
        (j % 2 == 0 ? framing : half).add(point);
      }
    }
    framing.add(half);
    const double angle = std::atan(tangent(15) * std::min(aspect, 1.0));
    EXPECT_NEAR(distanceOf(framing), 7 / std::sin(angle), 1e-3) << aspect;
  }
}

TEST(Framing, LooksStraightDownToo) {
  Framing framing(cameraAt({1, 50, 3}, 90), 1, 0);
  framing.add({1, 2, 8});
  EXPECT_NEAR(distanceOf(framing), 5, 1e-6);
}

// A point at the picture's edge stays there: 1 above the target, in a picture that spans from 0.4
// of its half height below the target to 1.6 above.
TEST(Framing, KnowsShifts) {
  Camera camera = cameraAt({1, 2, 90}, 90);
  camera.shiftY = 0.3F;
  Framing above(camera, 1);
  above.add({1, 3, 3});
  EXPECT_NEAR(distanceOf(above), 1 / 1.6, 1e-6);
  Framing below(camera, 1);
  below.add({1, 1, 3});
  EXPECT_NEAR(distanceOf(below), 1 / 0.4, 1e-6);
  camera.shiftX = -0.3F;
  Framing left(camera, 2);
  left.add({-1, 2, 3});
  EXPECT_NEAR(distanceOf(left), 2 / (2 * 1.6), 1e-6);
  camera.shiftX = 0.49F;
  EXPECT_NO_THROW(Framing(camera, 1, 0));
  EXPECT_THROW(Framing(camera, 1, 0.1), UsageError);
}

TEST(Framing, OrthographicCameraGetsAHeight) {
  Camera camera = cameraAt({1, 2, 90}, 40);
  camera.orthographicHeightMm = 20.0F;
  Framing framing(camera, 0.5, 0.2);
  EXPECT_TRUE(framing.isMet());
  framing.add({1, 2 + 7, -1000});
  EXPECT_TRUE(framing.isMet());
  framing.add({1 - 6, 2, 80});
  EXPECT_FALSE(framing.isMet());
  const Camera wide = framing.camera();
  EXPECT_EQ(wide.positionMm, camera.positionMm);
  EXPECT_NEAR(wide.orthographicHeightMm.value(), 2 * 6 / (0.5 * 0.8), 1e-4);
}

TEST(Framing, AsksForNothingWithoutPoints) {
  const Camera camera = cameraAt({1, 2, 90}, 40);
  Framing framing(camera, 1);
  framing.add({NAN, 0, 0});
  framing.add({INFINITY, 0, 0});
  EXPECT_TRUE(framing.isMet());
  EXPECT_EQ(framing.camera(), camera);
}

TEST(Framing, CameraMovesTheWayItLooks) {
  const Camera camera = cameraAt({1, 5, 7}, 90);
  Framing framing(camera, 1);
  framing.add({1 + 4, 2, 3});
  EXPECT_TRUE(framing.isMet());
  framing.add({1 + 10, 2, 3});
  EXPECT_FALSE(framing.isMet());
  EXPECT_EQ(framing.camera().positionMm, (Vec3{1, 8, 11}));
  EXPECT_EQ(framing.camera().targetMm, (Vec3{1, 2, 3}));
}

TEST(Framing, RefusesWhatSeesNothing) {
  const Camera camera = cameraAt({1, 2, 90}, 40);
  for (const double aspect : {0.0, -1.0, double{INFINITY}, double{NAN}})
    EXPECT_THROW(Framing(camera, aspect), UsageError);
  EXPECT_THROW(Framing(camera, 1, 1), UsageError);
  EXPECT_THROW(Framing(cameraAt(camera.targetMm, 40), 1), UsageError);
}

TEST(PlaceCamera, MovesWhatIsGivenAndKeepsTheDistanceInADirection) {
  Camera camera = cameraAt({1, 2, 13}, 30);
  camera.up = {1, 0, 0};
  const Vec3 target{4, 2, 3};
  placeCamera({}, camera);
  EXPECT_EQ(camera.up, (Vec3{1, 0, 0}));
  placeCamera({.targetMm = target}, camera);
  EXPECT_EQ(camera.positionMm, (Vec3{1, 2, 13}));
  EXPECT_EQ(camera.targetMm, target);
  EXPECT_EQ(camera.up, (Vec3{0, 1, 0}));
  camera = cameraAt({1, 2, 13}, 30);
  placeCamera({.targetMm = target, .direction = Vec3{0, 1, 0}}, camera);
  EXPECT_EQ(camera.positionMm, (Vec3{4, 12, 3}));
  EXPECT_EQ(camera.up, (Vec3{0, 0, -1}));
  placeCamera({.positionMm = Vec3{7, 2, 3}}, camera);
  EXPECT_EQ(camera.positionMm, (Vec3{7, 2, 3}));
  EXPECT_EQ(camera.targetMm, target);
}

TEST(Framing, UsualUpIsNeverWhereTheCameraLooks) {
  EXPECT_EQ(usualUp(cameraAt({5, 6, 7}, 40)), (Vec3{0, 1, 0}));
  EXPECT_EQ(usualUp(cameraAt({1, 60, 3}, 40)), (Vec3{0, 0, -1}));
  EXPECT_EQ(usualUp(cameraAt({1, -60, 3}, 40)), (Vec3{0, 0, 1}));
}

}  // namespace
}  // namespace opaline
