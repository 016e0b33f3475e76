#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"
#include "renderer/wobbly_ball.h"

namespace opaline::test {
namespace {

struct Change {
  const char* name;
  std::function<void(Renderer&, View&)> make;
  bool movesSight;
  bool movesShadows;
};

template <typename Edit>
std::function<void(Renderer&, View&)> withOptions(const Edit& edit) {
  return [edit](Renderer&, View& view) {
    RenderOptions options = view.options();
    edit(options);
    view.setOptions(options);
  };
}

std::vector<Change> changes() {
  return {
      {"a light turns", [](Renderer& r, View&) { r.setLighting(turned(wobblyBall().lighting)); },
       false, true},
      {"a light dims",
       [](Renderer& r, View&) {
         Lighting lighting = wobblyBall().lighting;
         lighting.directional[0].irradiance = {0.2F, 0.3F, 0.1F};
         r.setLighting(lighting);
       },
       false, false},
      {"a light comes",
       [](Renderer& r, View&) {
         Lighting lighting = wobblyBall().lighting;
         lighting.points = {{{30, 20, 10}, {500, 400, 300}}};
         r.setLighting(lighting);
       },
       false, true},
      {"the sky changes",
       [](Renderer& r, View&) {
         Lighting lighting = wobblyBall().lighting;
         lighting.environment = std::make_shared<const Image>(gradient());
         lighting.ambient = {0.1F, 0.2F, 0.3F};
         r.setLighting(lighting);
       },
       false, false},
      {"the camera moves",
       [](Renderer& r, View&) {
         Camera camera = wobblyBall().camera;
         camera.positionMm[0] += 3;
         r.setCamera(camera);
       },
       true, false},
      {"a deformer changes",
       [](Renderer& r, View&) {
         std::vector<Deformer> deformers = wobblyBall().deformers;
         deformers[0].amount = -1;
         r.setDeformers(deformers);
       },
       true, true},
      {"samples change", withOptions([](RenderOptions& o) { o.antialias = 2; }), true, false},
      {"the size changes", withOptions([](RenderOptions& o) { o.width += 5; }), true, false},
      {"shadow maps change", withOptions([](RenderOptions& o) { o.shadowSize = 64; }), false, true},
      {"the tolerance changes", withOptions([](RenderOptions& o) { o.tolerance = 0.05F; }), false,
       false},
  };
}

class SightReuseTest : public RendererTest, public testing::WithParamInterface<Method> {};

// The picture is, bit for bit, that of a renderer which finds everything.
TEST_P(SightReuseTest, WhatNothingMovesIsKept) {
  for (const Change& change : changes()) {
    SCOPED_TRACE(change.name);
    renderer().setScene(wobblyBall());
    View view(renderer(), optionsOf(GetParam()));
    view.render();
    ASSERT_TRUE(runs(view, "surface"));
    change.make(renderer(), view);
    const Image kept = view.render({.reuseLight = true}).images[0];
    // At fragments that pass also forgets what was asked of the surfaces.
    if (GetParam().site == Site::Vertex) {
      EXPECT_EQ(runs(view, "surface"), change.movesSight);
      EXPECT_EQ(runs(view, "shadow"), change.movesShadows);
    }
    EXPECT_EQ(kept.rgba, view.render().images[0].rgba);
  }
}

// Of several frames in a row the last holds what the next needs.
TEST_P(SightReuseTest, LightsTurnOneAfterTheOther) {
  const auto pictures = [&](bool reuse) {
    Scene scene = wobblyBall();
    Lighting& lighting = scene.lighting;
    lighting.ambient = {0.2F, 0.3F, 0.4F};
    lighting.points.push_back({{30, 20, 10}, {500, 400, 300}});
    renderer().setScene(scene);
    View view(renderer(), optionsOf(GetParam()));
    std::vector<std::vector<float>> shown;
    for (int i = 0; i < 5; ++i) {
      if (i % 2 == 0)
        lighting = turned(lighting);
      else
        lighting.points[0].positionMm[1] -= 4;
      renderer().setLighting(lighting);
      shown.push_back(view.render({.reuseLight = reuse}).images[0].rgba);
    }
    return shown;
  };
  EXPECT_EQ(pictures(true), pictures(false));
}

INSTANTIATE_TEST_SUITE_P(Methods, SightReuseTest, testing::ValuesIn(methods),
                         [](const auto& method) { return std::string(method.param.name); });

using SightTest = RendererTest;

// They take the room of the picture's surfaces.
TEST_F(SightTest, CentresOfPixelsComeBetween) {
  renderer().setScene(wobblyBall());
  View view(renderer(), optionsOf(methods[0]));
  view.render();
  view.render({.aovs = {Aov::Depth}, .reuseLight = true});
  renderer().setLighting(turned(wobblyBall().lighting));
  const Image kept = view.render({.reuseLight = true}).images[0];
  EXPECT_TRUE(runs(view, "surface"));
  EXPECT_EQ(kept.rgba, view.render().images[0].rgba);
}

// The room of surfaces holds the last band of a large picture.
TEST_F(SightTest, APictureOfSeveralBandsKeepsNone) {
  Scene scene = wobblyBall();
  scene.objects[0].opaque.emplace();  // of which more is known, so that bands are narrower
  scene.camera.positionMm[2] *= 20;
  renderer().setScene(scene);
  RenderOptions options = optionsOf(methods[0]);
  options.width = 4096;
  options.height = 64;
  options.antialias = 8;
  View view(renderer(), options);
  view.render();
  renderer().setLighting(turned(scene.lighting));
  const Image kept = view.render({.reuseLight = true}).images[0];
  EXPECT_TRUE(runs(view, "surface"));
  EXPECT_EQ(kept.rgba, view.render().images[0].rgba);
}

// What is behind surfaces shows at their edges.
TEST_F(SightTest, TheEnvironmentIsBehind) {
  Scene scene = wobblyBall();
  scene.lighting.environment = std::make_shared<const Image>(gradient());
  renderer().setScene(scene);
  RenderOptions options = optionsOf(methods[0]);
  options.environmentBehind = true;
  options.antialias = 4;
  View view(renderer(), options);
  view.render();
  renderer().setLighting(turned(scene.lighting));
  const Image kept = view.render({.reuseLight = true}).images[0];
  EXPECT_EQ(kept.rgba, view.render().images[0].rgba);
}

// A light that the picture shows is a surface of it.
TEST_F(SightTest, AVisibleLightMoves) {
  Scene scene = wobblyBall();
  const auto lampAt = [&](float x) {
    scene.lighting.areas = {
        AreaLight{SphereLight{.centreMm = {x, 8, 0}, .radiusMm = 2, .visible = true}}};
    return scene.lighting;
  };
  lampAt(4);
  renderer().setScene(scene);
  View view(renderer(), optionsOf(methods[0]));
  const Image before = view.render().images[0];
  renderer().setLighting(lampAt(-4));
  const Image kept = view.render({.reuseLight = true}).images[0];
  EXPECT_NE(kept.rgba, before.rgba);
  EXPECT_EQ(kept.rgba, view.render().images[0].rgba);
}

}  // namespace
}  // namespace opaline::test
