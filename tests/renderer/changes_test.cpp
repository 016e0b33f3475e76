#include <gtest/gtest.h>

#include <vector>

#include "opaline/error.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "renderer/shapes.h"

// What clips change besides nodes, compared with a scene that has the changed values.

namespace opaline {
namespace {

using namespace test;

class ChangesTest : public testing::Test {
 protected:
  ChangesTest() {
    scene_ = sceneOf(sphere({0, 0, 0}, 5, 3), marble(), {0, 0, 40}, 12);
    scene_.lighting.points = {{{20, 5, 10}, {400, 400, 400}}};
    Object plate;
    plate.name = "plate";
    plate.mesh = sphere({0, -9, 0}, 4, 3);
    plate.opaque = mattMaterial({0.5F, 0.5F, 0.5F});
    scene_.objects.push_back(plate);
    scene_.clips = {{"go", 2, {}}, {"rest", 1, {}}};
  }
  Image picture(const Scene& scene, double seconds, int clip = 0) {
    renderer_.setScene(scene);
    renderer_.setTime({seconds, clip});
    return renderer_.render(options()).images[0];
  }
  static RenderOptions options() {
    RenderOptions options;
    options.width = options.height = 48;
    options.antialias = 1;
    options.maxClusters = 512;
    return options;
  }

  Scene scene_;
  Renderer renderer_;
};

TEST_F(ChangesTest, LightsAndCamera) {
  Scene expected = scene_;
  expected.lighting.points[0] = {{10, 10, 20}, {300, 200, 100}};
  expected.camera.positionMm = {4, 0, 40};
  expected.camera.verticalFovDegrees = 20;
  PointLight last = expected.lighting.points[0];
  Camera lastView = expected.camera;
  for (std::size_t i = 0; i < 3; ++i) {  // moved on by the same amount
    last.positionMm[i] = 2 * last.positionMm[i] - scene_.lighting.points[0].positionMm[i];
    last.intensity[i] = 2 * last.intensity[i] - scene_.lighting.points[0].intensity[i];
    lastView.positionMm[i] = 2 * lastView.positionMm[i] - scene_.camera.positionMm[i];
  }
  lastView.verticalFovDegrees = 2 * lastView.verticalFovDegrees - scene_.camera.verticalFovDegrees;
  last.intensity[2] = 0;
  expected.lighting.points[0].intensity[2] = 200;
  scene_.changes.resize(1);
  scene_.changes[0].points = {{0, {0, 2}, {scene_.lighting.points[0], last}}};
  scene_.changes[0].cameras = {{0, {0, 2}, {scene_.camera, lastView}}};
  EXPECT_EQ(picture(scene_, 1).rgba, picture(expected, 1).rgba);
  Scene still = scene_;
  still.changes.clear();
  EXPECT_EQ(picture(scene_, 1, 1).rgba, picture(still, 1).rgba);
}

TEST_F(ChangesTest, SurfacesAndBack) {
  OpaqueMaterial red = *scene_.objects[1].opaque;
  red.baseColor = {1, 0, 0.25F};
  red.emission = {1, 0, 2};
  Scene expected = scene_;
  expected.objects[1].opaque->baseColor = {0.75F, 0.25F, 0.375F};
  expected.objects[1].opaque->emission = {0.5F, 0, 1};
  Scene still = scene_;
  scene_.changes.resize(1);
  scene_.changes[0].surfaces = {{1, {0, 2}, {*scene_.objects[1].opaque, red}}};
  EXPECT_EQ(picture(scene_, 1).rgba, picture(expected, 1).rgba);
  renderer_.setScene(scene_);
  for (const int clip : {0, 1}) {  // each frame must find what the previous one changed undone
    renderer_.setTime({1, clip});
    const Image now = renderer_.render(options()).images[0];
    if (clip == 1) {
      EXPECT_EQ(now.rgba, picture(still, 0).rgba);
    }
  }
}

// The surface is divided for the finest medium. It comes first here, so it is also the medium of
// the scene in which another replaces it.
TEST_F(ChangesTest, Media) {
  Medium dark = scene_.objects[0].medium;
  for (std::size_t c = 0; c < 3; ++c) {
    dark.sigmaSPrimePerMm[c] *= 0.5;
    dark.sigmaAPerMm[c] += 0.01;
  }
  Scene expected = scene_;
  for (std::size_t c = 0; c < 3; ++c) {
    double& s = expected.objects[0].medium.sigmaSPrimePerMm[c];
    double& a = expected.objects[0].medium.sigmaAPerMm[c];
    s = 0.5 * s + 0.5 * dark.sigmaSPrimePerMm[c];
    a = 0.5 * a + 0.5 * dark.sigmaAPerMm[c];
  }
  // Never shown, but the surface is divided for this medium.
  expected.changes.resize(2);
  expected.changes[1].media = {{0, {0}, {scene_.objects[0].medium}}};
  scene_.changes.resize(1);
  scene_.changes[0].media = {{0, {0, 2}, {scene_.objects[0].medium, dark}}};
  EXPECT_EQ(picture(scene_, 1).rgba, picture(expected, 1).rgba);
  EXPECT_NE(picture(scene_, 1).rgba, picture(scene_, 0).rgba);
}

// As when an edit is undone.
TEST_F(ChangesTest, ALightThatIsAsItWasSetFollowsItsClipAgain) {
  scene_.changes.resize(1);
  scene_.changes[0].points = {{0, {0, 2}, {scene_.lighting.points[0], {{0, 0, 30}, {1, 1, 1}}}}};
  const Image expected = picture(scene_, 1);
  renderer_.setScene(scene_);
  renderer_.setTime({1, 0});
  Lighting other = scene_.lighting;
  other.points.clear();
  for (const Lighting& lighting : {other, scene_.lighting}) renderer_.setLighting(lighting);
  EXPECT_EQ(renderer_.render(options()).images[0].rgba, expected.rgba);
  renderer_.setLighting(other);
  renderer_.setTime({0, 0});
  renderer_.setLighting(scene_.lighting);
  renderer_.setTime({1, 0});
  EXPECT_EQ(renderer_.render(options()).images[0].rgba, expected.rgba);
}

TEST_F(ChangesTest, ALightFollowsItsClipWhenOthersAreRemoved) {
  const PointLight still{{20, 0, 30}, {50, 500, 50}};
  const PointLight last{{0, 0, 30}, {1, 1, 1}};
  const PointLight lamp = scene_.lighting.points[0];
  scene_.changes.resize(1);
  scene_.changes[0].points = {{0, {0, 2}, {lamp, last}}};
  const Image alone = picture(scene_, 1);
  scene_.lighting.points = {still, lamp};
  scene_.changes[0].points[0].index = 1;
  const Image both = picture(scene_, 1);
  EXPECT_NE(alone.rgba, both.rgba);
  renderer_.setScene(scene_);
  renderer_.setTime({1, 0});
  Lighting lighting = scene_.lighting;
  lighting.points = {lamp};
  renderer_.setLighting(lighting);
  EXPECT_EQ(renderer_.render(options()).images[0].rgba, alone.rgba);
  lighting.points = {still, lamp};
  renderer_.setLighting(lighting);
  EXPECT_EQ(renderer_.render(options()).images[0].rgba, both.rgba);
}

TEST_F(ChangesTest, AMaterialThatIsAsItWasSetFollowsItsClipAgain) {
  Medium dark = scene_.objects[0].medium;
  dark.sigmaAPerMm = {1, 1, 1};
  OpaqueMaterial red = *scene_.objects[1].opaque;
  red.baseColor = {1, 0, 0};
  scene_.changes.resize(1);
  scene_.changes[0].media = {{0, {0, 2}, {scene_.objects[0].medium, dark}}};
  scene_.changes[0].surfaces = {{1, {0, 2}, {*scene_.objects[1].opaque, red}}};
  const Image expected = picture(scene_, 1);
  renderer_.setScene(scene_);
  renderer_.setTime({1, 0});
  const auto give = [&](const Medium& medium, const OpaqueMaterial& opaque) {
    renderer_.setMedium(0, medium);
    Material plate = materialOf(scene_.objects[1]);
    plate.opaque = opaque;
    renderer_.setMaterial(1, plate);
    return renderer_.render(options()).images[0];
  };
  EXPECT_NE(give(dark, red).rgba, expected.rgba);
  const Image back = give(scene_.objects[0].medium, *scene_.objects[1].opaque);
  EXPECT_EQ(back.rgba, expected.rgba);
}

TEST_F(ChangesTest, WhatIsEditedFollowsNoClipAnyMore) {
  scene_.changes.resize(1);
  scene_.changes[0].points = {{0, {0, 2}, {scene_.lighting.points[0], {{0, 0, 30}, {1, 1, 1}}}}};
  Scene other = scene_;
  other.lighting.points[0].intensity = {100, 100, 100};
  renderer_.setScene(scene_);
  renderer_.setLighting(other.lighting);
  renderer_.setTime({1, 0});
  const Image edited = renderer_.render(options()).images[0];
  other.changes.clear();
  EXPECT_EQ(edited.rgba, picture(other, 1).rgba);
}

// A camera that somebody moved stays where it was put, even if only its lens was shifted.
TEST_F(ChangesTest, AShiftedCameraFollowsNoClip) {
  Camera lastView = scene_.camera;
  lastView.positionMm[0] += 10;
  scene_.changes.resize(1);
  scene_.changes[0].cameras = {{0, {0, 2}, {scene_.camera, lastView}}};
  Camera shifted = scene_.camera;
  shifted.shiftX = 0.1F;
  renderer_.setScene(scene_);
  renderer_.setCamera(shifted);
  renderer_.setTime({1, 0});
  const Image found = renderer_.render(options()).images[0];
  Scene expected = scene_;
  expected.changes[0].cameras.clear();
  expected.camera = shifted;
  EXPECT_EQ(found.rgba, picture(expected, 1).rgba);
}

TEST_F(ChangesTest, ThoseThatMakeNoSenseAreErrors) {
  const auto refuses = [&](ClipChanges changes) {
    Scene scene = scene_;
    scene.changes = {std::move(changes)};
    EXPECT_THROW(renderer_.setScene(scene), Error);
  };
  const PointLight light = scene_.lighting.points[0];
  refuses({.points = {{0, {}, {}}}});
  refuses({.points = {{0, {0, 1}, {light}}}});
  refuses({.points = {{0, {1, 0}, {light, light}}}});
  refuses({.points = {{0, {0}, {{{0, 0, 0}, {-1, 0, 0}}}}}});
  refuses({.surfaces = {{0, {0}, {*scene_.objects[1].opaque}}}});
  refuses({.media = {{1, {0}, {marble()}}}});
}

}  // namespace
}  // namespace opaline
