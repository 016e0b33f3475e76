#include <gtest/gtest.h>

#include <limits>
#include <variant>

#include "opaline/error.h"
#include "opaline/scene.h"

namespace opaline {
namespace {

Scene lit() {
  Scene scene;
  scene.lighting.directional.push_back({{0, 0, 1}, {3, 2, 1}});
  scene.lighting.points.push_back({{1, 2, 3}, {4, 5, 6}});
  scene.lighting.spots.push_back({{0, 8, 0}, {0, -1, 0}, {7, 7, 7}, 10, 20});
  scene.lighting.areas.emplace_back(SphereLight{{2, 0, 0}, 0.5F, {9, 9, 9}});
  scene.lighting.areas.emplace_back(RectangleLight{{0, 1, 0}, {3, 0, 0}, {0, 0, 4}, {2, 2, 2}});
  scene.lighting.areas.emplace_back(TubeLight{{0, 0, 0}, {0, 6, 0}, 0.25F, {1, 1, 1}});
  scene.lighting.ambient = {0.1F, 0.2F, 0.3F};
  scene.camera = {.positionMm = {0, 0, 30}, .targetMm = {0, 1, 0}};
  scene.camera.orthographicHeightMm = 12;
  scene.changes.emplace_back().points.push_back(
      {0, {0, 1}, {{{1, 2, 3}, {4, 5, 6}}, {{2, 4, 6}, {1, 1, 1}}}});
  return scene;
}

// At twice the distance a point must be four times as strong; a radiance stays the same.
TEST(ScaledLights, KeepTheIrradianceOfBodiesThatGrewAlike) {
  Scene scene = lit();
  scaleLightsAndCamera(2, scene);
  const Lighting& lights = scene.lighting;
  EXPECT_EQ(lights.directional, lit().lighting.directional);
  EXPECT_EQ(lights.points[0], (PointLight{{2, 4, 6}, {16, 20, 24}}));
  EXPECT_EQ(lights.spots[0], (SpotLight{{0, 16, 0}, {0, -1, 0}, {28, 28, 28}, 10, 20}));
  EXPECT_EQ(std::get<SphereLight>(lights.areas[0]), (SphereLight{{4, 0, 0}, 1, {9, 9, 9}}));
  EXPECT_EQ(std::get<RectangleLight>(lights.areas[1]),
            (RectangleLight{{0, 2, 0}, {6, 0, 0}, {0, 0, 8}, {2, 2, 2}}));
  EXPECT_EQ(std::get<TubeLight>(lights.areas[2]),
            (TubeLight{{0, 0, 0}, {0, 12, 0}, 0.5F, {1, 1, 1}}));
  EXPECT_EQ(lights.ambient, lit().lighting.ambient);
  EXPECT_EQ(scene.camera.positionMm, (Vec3{0, 0, 60}));
  EXPECT_EQ(scene.camera.targetMm, (Vec3{0, 2, 0}));
  EXPECT_EQ(scene.camera.orthographicHeightMm, 24.F);
  EXPECT_EQ(scene.changes[0].points[0].values[1], (PointLight{{4, 8, 12}, {4, 4, 4}}));
  scaleLightsAndCamera(0.5, scene);
  EXPECT_EQ(scene.lighting.points, lit().lighting.points);
  EXPECT_EQ(scene.camera, lit().camera);
}

TEST(ScaledLights, StayWhereTheyCannotBeScaled) {
  for (const double factor : {0., -1., 1e30, std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity()}) {
    Scene scene = lit();
    EXPECT_THROW(scaleLightsAndCamera(factor, scene), UsageError) << factor;
    EXPECT_EQ(scene.lighting.points, lit().lighting.points);
    EXPECT_EQ(scene.lighting.areas, lit().lighting.areas);
    EXPECT_EQ(scene.camera, lit().camera);
  }
}

}  // namespace
}  // namespace opaline
