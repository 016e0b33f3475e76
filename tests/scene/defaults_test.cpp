#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "opaline/error.h"
#include "opaline/scene.h"
#include "scene/shapes.h"
#include "scene/text.h"

namespace opaline {
namespace {

Scene boxScene() {
  Scene scene;
  const scene::RawMesh cube = test::cube({1, 2, 3}, 2);
  scene.objects.push_back({"cube", {cube.positions, {}, cube.triangles}, {}});
  return scene;
}

TEST(Defaults, CameraStandsOnPlusZ) {
  const Scene scene = boxScene();
  EXPECT_NEAR(diagonalMm(scene), 2 * std::sqrt(3.0F), 1e-5F);
  const Camera camera = defaultCamera(scene);
  EXPECT_EQ(camera.targetMm, (Vec3{2, 3, 4}));
  EXPECT_EQ(camera.verticalFovDegrees, 30);
  EXPECT_NEAR(camera.positionMm[2], 4 + 1.4F * 2 * std::sqrt(3.0F), 1e-5F);
  EXPECT_EQ(camera.positionMm[0], 2);
}

TEST(Defaults, CameraFromAboveHasAnUpThatItCanUse) {
  for (const float y : {1.0F, -5.0F}) {
    const Camera camera = defaultCamera(boxScene(), {0, y, 0}, 45);
    EXPECT_EQ(camera.up[1], 0);
    EXPECT_EQ(std::abs(camera.up[2]), 1);
  }
}

TEST(Defaults, SenselessCamerasAreRefused) {
  EXPECT_THROW(defaultCamera(boxScene(), {0, 0, 0}), UsageError);
  EXPECT_THROW(defaultCamera(boxScene(), {0, NAN, 1}), UsageError);
  EXPECT_THROW(defaultCamera(boxScene(), {0, 0, 1}, 0.5F), UsageError);
  EXPECT_THROW(defaultCamera(boxScene(), {0, 0, 1}, 171), UsageError);
}

TEST(Defaults, KeyComesFromBehindAndIsStrongest) {
  const Lighting lighting = defaultLighting();
  ASSERT_EQ(lighting.directional.size(), 2U);
  EXPECT_LT(lighting.directional[0].directionToLight[2], -0.7F);
  EXPECT_GT(lighting.directional[1].directionToLight[2], 0.5F);
  EXPECT_LT(lighting.directional[1].directionToLight[0], 0);
  for (const DirectionalLight& light : lighting.directional) {
    const Vec3& d = light.directionToLight;
    EXPECT_NEAR(std::hypot(d[0], d[1], d[2]), 1, 1e-6F);
  }
  EXPECT_GT(lighting.directional[0].irradiance[1], 8 * lighting.directional[1].irradiance[1]);
  EXPECT_GT(lighting.ambient[0], 0);
}

TEST(Defaults, EmptySceneHasNoSize) {
  EXPECT_EQ(boundsOf(Scene{}).maxMm, (Vec3{0, 0, 0}));
  EXPECT_EQ(diagonalMm(Scene{}), 0);
}

TEST(Text, BadBytesAreReplaced) {
  EXPECT_EQ(scene::cleanText("gr\xC3\xBCn"), "gr\xC3\xBCn");
  EXPECT_EQ(scene::cleanText("a\xFF"
                             "b"),
            "a\xEF\xBF\xBD"
            "b");
  EXPECT_EQ(scene::cleanText("\xC0\x80"), "\xEF\xBF\xBD\xEF\xBF\xBD");  // overlong
  EXPECT_EQ(scene::cleanText("\xE2\x82"), "\xEF\xBF\xBD\xEF\xBF\xBD");  // cut short
  EXPECT_EQ(scene::cleanText("a\nb\x1B"), "a b\xEF\xBF\xBD");
}

TEST(Text, NearestIsByEditDistance) {
  const std::vector<std::string_view> keys{"medium", "model", "media"};
  EXPECT_EQ(scene::suggestionOrList("modle", keys), "; the nearest is 'model'");
  EXPECT_EQ(scene::suggestionOrList("meduim", keys), "; the nearest is 'medium'");
  EXPECT_EQ(scene::suggestionOrList("model_of", keys), "; the nearest is 'model'");
  EXPECT_EQ(scene::suggestionOrList("", keys), "; there are 'medium', 'model' and 'media'");
}

TEST(Text, WhatIsThereIsListedWhereNothingIsNear) {
  const std::vector<std::string_view> names{"lid", "pot", "spout", "handle", "rim", "knob"};
  EXPECT_EQ(scene::suggestionOrList("pott", names), "; the nearest is 'pot'");
  EXPECT_EQ(scene::suggestionOrList("saucer", names),
            "; there are 'lid', 'pot', 'spout', 'handle' and 2 more");
  EXPECT_EQ(scene::suggestionOrList("saucer", names, 1), "; there are 'lid' and 5 more");
  EXPECT_EQ(scene::suggestionOrList("saucer", std::span(names).first(1)), "; there is only 'lid'");
  EXPECT_EQ(scene::suggestionOrList("saucer", {}), "");
}

}  // namespace
}  // namespace opaline
