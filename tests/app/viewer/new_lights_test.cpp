#include "viewer/picture/new_lights.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>
#include <vector>

#include "viewer/picture/light_handles.h"
#include "viewer/picture/vectors.h"

namespace opaline::app::viewer {
namespace {

/// A scene of 20 mm about the origin.
class NewLightsTest : public testing::Test {
 protected:
  NewLightsTest() {
    ImGui::CreateContext();
    session.diagonalMm = 20;
    session.scene.camera.targetMm = {0, 0, 0};
    look({0, 0, 45});
  }
  ~NewLightsTest() override { ImGui::DestroyContext(); }

  void look(const Vec3& fromMm) { session.scene.camera.positionMm = fromMm; }
  NewLights made(const Area& area) const { return {session, {session.scene.camera, area}}; }

  /// One light of each kind, each placed beside those before.
  void addAll(const Area& area) {
    Lighting& lighting = session.scene.lighting;
    lighting.directional.push_back(made(area).directional());
    lighting.points.push_back(made(area).point());
    lighting.spots.push_back(made(area).spot());
    lighting.areas.emplace_back(made(area).rectangle());
    lighting.areas.emplace_back(made(area).disc());
    lighting.areas.emplace_back(made(area).sphere());
    lighting.areas.emplace_back(made(area).tube());
  }

  void expectApartInside(const Area& area) const {
    const Projection projection(session.scene.camera, area);
    std::vector<glm::vec2> found;
    for (const glm::vec3& placeMm : placesOfHandles(session, projection)) {
      const auto place = projection.toWindow(placeMm);
      ASSERT_TRUE(place);
      EXPECT_TRUE(area.holds(place->x, place->y, reachOfHandles())) << place->x << " " << place->y;
      for (const glm::vec2& other : found) EXPECT_GT(glm::length(*place - other), reachOfHandles());
      found.push_back(*place);
    }
  }

  Session session;
};

TEST_F(NewLightsTest, HandlesAreInsideAPictureOfAnyShapeAndApart) {
  for (const Area& area : {Area{0, 0, 800, 600}, Area{0, 0, 270, 700}, Area{40, 10, 700, 200}}) {
    for (const Vec3& camera : {Vec3{0, 0, 45}, Vec3{45, 0, 0}, Vec3{0, 40, 20}, Vec3{0, 3, 12}}) {
      session.scene.lighting = {};
      look(camera);
      addAll(area);
      addAll(area);
      expectApartInside(area);
    }
  }
}

TEST_F(NewLightsTest, InAWidePictureALightIsBehindTheSceneToTheRightAndAbove) {
  const Vec3 place = made({0, 0, 1200, 600}).point().positionMm;
  EXPECT_NEAR(place[0], 10, 1e-4);
  EXPECT_NEAR(place[1], 8, 1e-4);
  EXPECT_NEAR(place[2], -8, 1e-4);
}

TEST_F(NewLightsTest, LightsShineOnTheTarget) {
  const NewLights lights = made({0, 0, 270, 700});
  const auto expectTowardsTarget = [&](const Vec3& placeMm, const glm::vec3& direction) {
    EXPECT_NEAR(glm::dot(glm::normalize(-toGlm(placeMm)), direction), 1, 1e-5);
  };
  expectTowardsTarget(lights.spot().positionMm, toGlm(lights.spot().direction));
  expectTowardsTarget(lights.disc().centreMm, toGlm(lights.disc().normal));
  const RectangleLight rectangle = lights.rectangle();
  expectTowardsTarget(rectangle.centreMm,
                      glm::normalize(glm::cross(toGlm(rectangle.uMm), toGlm(rectangle.vMm))));
}

}  // namespace
}  // namespace opaline::app::viewer
