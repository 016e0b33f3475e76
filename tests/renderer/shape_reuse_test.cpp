#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <vector>

#include "renderer/renderer_fixture.h"
#include "renderer/wobbly_ball.h"

namespace opaline::test {
namespace {

struct Change {
  const char* name;
  std::function<void(Renderer&, View&)> make;
  bool movesShape;
};

std::vector<Change> changes() {
  return {
      {"a light turns", [](Renderer& r, View&) { r.setLighting(turned(wobblyBall().lighting)); },
       false},
      {"a light goes",
       [](Renderer& r, View&) {
         Lighting lighting = wobblyBall().lighting;
         lighting.directional.clear();
         lighting.points = {{{30, 20, 10}, {500, 400, 300}}};
         r.setLighting(lighting);
       },
       false},
      {"an area light comes",
       [](Renderer& r, View&) {
         Lighting lighting = wobblyBall().lighting;
         lighting.areas = {AreaLight{SphereLight{.centreMm = {0, 60, 0}, .radiusMm = 5}}};
         r.setLighting(lighting);
       },
       false},
      {"the sky changes",
       [](Renderer& r, View&) {
         Lighting lighting = wobblyBall().lighting;
         lighting.environment = std::make_shared<const Image>(gradient());
         r.setLighting(lighting);
       },
       true},
      {"a medium changes",
       [](Renderer& r, View&) {
         Medium medium = wobblyBall().objects[0].medium;
         medium.sigmaAPerMm = {0.3, 0.2, 0.1};
         r.setMedium(0, medium);
       },
       true},
      {"a deformer changes",
       [](Renderer& r, View&) {
         std::vector<Deformer> deformers = wobblyBall().deformers;
         deformers[0].amount = -1;
         r.setDeformers(deformers);
       },
       true},
      {"time passes", [](Renderer& r, View&) { r.setTime({.seconds = 0.4}); }, true},
      {"the tolerance changes",
       [](Renderer&, View& v) {
         RenderOptions options = v.options();
         options.tolerance = 0.05F;
         v.setOptions(options);
       },
       true},
      {"bounces go",
       [](Renderer&, View& v) {
         RenderOptions options = v.options();
         options.bounces = 0;
         v.setOptions(options);
       },
       true},
  };
}

using ShapeReuseTest = RendererTest;

// The picture must equal bit by bit that of a renderer which computes everything.
TEST_F(ShapeReuseTest, WhatALightDoesNotMoveIsKept) {
  for (const Change& change : changes()) {
    SCOPED_TRACE(change.name);
    renderer().setScene(wobblyBall());
    renderer().setTime({});
    View view(renderer(), optionsOf(methods[0]));
    view.render();
    ASSERT_TRUE(runs(view, "deform"));
    change.make(renderer(), view);
    const Image kept = view.render({.reuseLight = true}).images[0];
    EXPECT_EQ(runs(view, "deform"), change.movesShape);
    EXPECT_TRUE(runs(view, "gather"));
    const Image whole = view.render().images[0];
    EXPECT_TRUE(runs(view, "deform"));
    EXPECT_EQ(kept.rgba, whole.rgba);
  }
}

// For a medium whose light from everywhere is followed to its collisions, the light that it gives
// to clusters.
TEST_F(ShapeReuseTest, WhatComesFromEverywhereIsKept) {
  Scene scene = wobblyBall();
  scene.objects[0].medium = skin();
  scene.lighting.ambient = {0.3F, 0.4F, 0.5F};
  renderer().setScene(scene);
  View view(renderer(), optionsOf(methods[0]));
  const Image before = view.render().images[0];
  renderer().setLighting(turned(scene.lighting));
  const Image kept = view.render({.reuseLight = true}).images[0];
  EXPECT_FALSE(runs(view, "deform"));
  EXPECT_NE(kept.rgba, before.rgba);
  EXPECT_EQ(kept.rgba, view.render().images[0].rgba);
}

// Views with one division share one shape.
TEST_F(ShapeReuseTest, AnotherViewMayHaveFoundIt) {
  renderer().setScene(wobblyBall());
  View first(renderer(), optionsOf(methods[0]));
  View second(renderer(), optionsOf(methods[0]));
  const Image whole = second.render().images[0];
  first.render({.reuseLight = true});
  EXPECT_FALSE(runs(first, "deform"));
  renderer().setLighting(turned(wobblyBall().lighting));
  first.render({.reuseLight = true});
  EXPECT_FALSE(runs(first, "deform"));
  renderer().setLighting(wobblyBall().lighting);
  EXPECT_EQ(second.render({.reuseLight = true}).images[0].rgba, whole.rgba);
}

// A clip that moves no vertex, and the parts of a frame that it recomputes.
TEST_F(ShapeReuseTest, TimeThatMovesLightsOrTheCameraAloneKeepsTheShape) {
  Scene scene = wobblyBall();
  scene.deformers.clear();
  scene.clips = {{"go", 1, {}}};
  const auto atHalfTime = [&](const ClipChanges& changes, bool movesLight) {
    scene.changes = {changes};
    renderer().setScene(scene);
    View view(renderer(), optionsOf(methods[0]));
    const Image before = view.render({.reuseLight = true}).images[0];
    renderer().setTime({.seconds = 0.5});
    const Image kept = view.render({.reuseLight = true}).images[0];
    EXPECT_FALSE(runs(view, "deform"));
    EXPECT_EQ(runs(view, "gather"), movesLight);
    EXPECT_NE(kept.rgba, before.rgba);
    EXPECT_EQ(kept.rgba, view.render().images[0].rgba);
  };
  Camera aside = scene.camera;
  aside.positionMm[0] += 9;
  atHalfTime({.cameras = {{0, {0, 1}, {scene.camera, aside}}}}, false);
  const DirectionalLight light = scene.lighting.directional[0];
  const DirectionalLight brighter{light.directionToLight, {9, 9, 9}};
  atHalfTime({.directional = {{0, {0, 1}, {light, brighter}}}}, true);
}

}  // namespace
}  // namespace opaline::test
