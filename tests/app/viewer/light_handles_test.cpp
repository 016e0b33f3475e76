#include "viewer/picture/light_handles.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace opaline::app::viewer {
namespace {

constexpr float nearPixels = 0.02F;

/// A camera on the z axis, 100 mm from the origin, whose picture of 200x200 pixels shows 100x100 mm
/// there: a place (x, y, 0) is at the pixel (100 + 2 x, 100 - 2 y).
class LightHandlesTest : public testing::Test {
 protected:
  LightHandlesTest() {
    ImGui::CreateContext();
    Camera& camera = session.scene.camera;
    camera.positionMm = {0, 0, 100};
    camera.targetMm = {0, 0, 0};
    camera.orthographicHeightMm.reset();
    camera.verticalFovDegrees = 53.1301024F;  // twice the angle whose tangent is 1/2
    session.diagonalMm = 20;
  }
  ~LightHandlesTest() override { ImGui::DestroyContext(); }

  Projection projection() const { return {session.scene.camera, {0, 0, 200, 200}}; }
  std::optional<LightHandle> at(const glm::vec2& pixel) const {
    return handles.at(session, projection(), pixel);
  }
  /// Takes hold of what is at a pixel, and selects it.
  void grab(const glm::vec2& pixel) {
    const auto handle = at(pixel);
    ASSERT_TRUE(handle);
    handles.grab(session, projection(), *handle, pixel);
    session.light = handle->light;
  }
  bool drag(const glm::vec2& pixel) { return handles.drag(session, projection(), pixel); }

  Session session;
  LightHandles handles;
};

TEST_F(LightHandlesTest, AHandleGrabbedBesideItsMiddleMovesAsFarAsTheMouse) {
  session.scene.lighting.points = {{{10, 20, 0}, {1, 1, 1}}};  // at the pixel (120, 60)
  grab({126, 55});
  ASSERT_TRUE(drag({126, 55}));
  const Vec3& place = session.scene.lighting.points[0].positionMm;
  EXPECT_NEAR(place[0], 10, 1e-3);
  EXPECT_NEAR(place[1], 20, 1e-3);
  ASSERT_TRUE(drag({136, 75}));  // 10 pixels to the right and 20 down
  EXPECT_NEAR(place[0], 15, 1e-3);
  EXPECT_NEAR(place[1], 10, 1e-3);
  EXPECT_NEAR(place[2], 0, 1e-3);
}

TEST_F(LightHandlesTest, ALightFromAfarStaysWhereItIsWhenGrabbedBesideItsHandle) {
  session.scene.lighting.directional = {{{0.6F, 0, 0.8F}, {1, 1, 1}}};
  // The sphere's radius is 11 mm: the handle is at (6.6, 0, 8.8), 91.2 mm from the camera.
  const glm::vec2 middle(100 + 200 * 6.6F / 91.2F, 100);
  grab(middle + glm::vec2(5, 7));
  ASSERT_TRUE(drag(middle + glm::vec2(5, 7)));
  const Vec3& direction = session.scene.lighting.directional[0].directionToLight;
  EXPECT_NEAR(direction[0], 0.6, 1e-3);
  EXPECT_NEAR(direction[1], 0, 1e-3);
  EXPECT_NEAR(direction[2], 0.8, 1e-3);
}

TEST_F(LightHandlesTest, OfHandlesUponEachOtherTheSelectedLightsIsGrabbed) {
  session.scene.lighting.points = {
      {{10, 20, 0}, {1, 1, 1}}, {{10, 20, 0}, {1, 1, 1}}, {{10.5F, 20, 0}, {1, 1, 1}}};
  for (session.light = 0; session.light < 3; ++session.light) {
    for (const glm::vec2 pixel : {glm::vec2(120, 60), glm::vec2(121, 60)}) {
      const auto handle = at(pixel);
      ASSERT_TRUE(handle);
      EXPECT_EQ(handle->light, session.light);
    }
  }
}

TEST_F(LightHandlesTest, OfHandlesBesideEachOtherTheNearestIsGrabbed) {
  session.scene.lighting.points = {{{10, 20, 0}, {1, 1, 1}}, {{15, 20, 0}, {1, 1, 1}}};
  session.light = 0;  // at the pixel (120, 60), and the other one at (130, 60)
  EXPECT_EQ(at({122, 60})->light, 0);
  EXPECT_EQ(at({129, 60})->light, 1);
  EXPECT_FALSE(at({120, 80}));
}

// The spot is 20 mm to the left of the target and shines to the right, so that the ring is on the
// target, at the pixel (100, 100).
TEST_F(LightHandlesTest, TheRingOfASpotStaysUnderTheMouse) {
  session.scene.lighting.spots = {{{-20, 0, 0}, {1, 0, 0}, {1, 1, 1}, 20, 30}};
  session.light = 0;
  grab({103, 98});
  ASSERT_TRUE(drag({123, 38}));
  const auto ring = at({120, 40});
  ASSERT_TRUE(ring);
  EXPECT_EQ(ring->part, LightPart::Aim);
  const auto place = projection().toWindow(ring->placeMm);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x, 120, nearPixels);
  EXPECT_NEAR(place->y, 40, nearPixels);
  // The ring is at (10, 30, 0), so the light shines along (30, 30, 0).
  const Vec3& direction = session.scene.lighting.spots[0].direction;
  EXPECT_NEAR(direction[0], std::sqrt(0.5), 1e-4);
  EXPECT_NEAR(direction[1], std::sqrt(0.5), 1e-4);
  EXPECT_NEAR(direction[2], 0, 1e-4);
}

TEST_F(LightHandlesTest, TheRingOnADiscsNormalStaysUnderTheMouse) {
  session.scene.lighting.areas = {DiscLight{{0, 0, 0}, {1, 0, 0}, 1, {1, 1, 1}}};
  session.light = 0;
  grab({108, 100});  // a fifth of the diagonal from the middle
  ASSERT_TRUE(drag({108, 40}));
  const auto ring = at({108, 40});
  ASSERT_TRUE(ring);
  EXPECT_EQ(ring->part, LightPart::Grip);
  EXPECT_EQ(ring->grip, AreaGrip::Kind::Normal);
  handles.release();
  EXPECT_FALSE(at({108, 40})) << "it is back on the normal's end";
}

}  // namespace
}  // namespace opaline::app::viewer
