#include "viewer/session/stage.h"

#include <gtest/gtest.h>

#include "opaline/error.h"
#include "renderer/shapes.h"

namespace opaline::app::viewer {
namespace {

Session litCube() {
  Session session;
  session.scene = test::sceneOf(test::box({0, 0, 0}, {5, 5, 5}, 1), test::marble(), {0, 0, 40}, 9);
  session.scene.lighting.ambient = {1, 1, 1};
  session.options.transport = Transport::Dipole;
  session.options.maxSurfels = 1024;
  session.options.shadowSize = 64;
  session.aov = Aov::Exitance;
  session.edits.material.assign(1, false);
  return session;
}

Image exitanceOf(Stage& stage, Session& session) {
  stage.draw(session, 16, 16, false);
  stage.finish();
  return *stage.variableImage();
}

TEST(StageTest, ASceneThatIsRefusedLeavesTheOneBefore) {
  Renderer renderer;
  RenderNotes notes;
  Stage stage(renderer, renderer.vulkanDevice(), notes);
  Session session = litCube();
  stage.setScene(session.scene, {});
  const Image before = exitanceOf(stage, session);
  EXPECT_GT(before.pixel(8, 8)[0], 0);
  EXPECT_THROW(stage.setScene({}, session.scene), Error);
  ASSERT_TRUE(stage.hasScene());
  EXPECT_EQ(exitanceOf(stage, session).rgba, before.rgba);
}

TEST(StageTest, WithoutASceneBeforeThereIsNone) {
  Renderer renderer;
  RenderNotes notes;
  Stage stage(renderer, renderer.vulkanDevice(), notes);
  EXPECT_THROW(stage.setScene({}, {}), Error);
  EXPECT_FALSE(stage.hasScene());
}

// As when the edit is undone.
TEST(StageTest, AMaterialThatIsAsItWasFollowsItsClipAgain) {
  Renderer renderer;
  RenderNotes notes;
  Stage stage(renderer, renderer.vulkanDevice(), notes);
  Session session = litCube();
  const Medium own = session.scene.objects[0].medium;
  Medium dark = own;
  dark.sigmaAPerMm = {1, 1, 1};
  session.scene.clips = {{"go", 2, {}}};
  session.scene.changes.resize(1);
  session.scene.changes[0].media = {{0, {0, 2}, {own, dark}}};
  session.time = {.seconds = 1, .clip = 0};
  stage.setScene(session.scene, {});
  const Image moved = exitanceOf(stage, session);
  const auto edited = [&](const Medium& medium) {
    session.scene.objects[0].medium = medium;
    session.edits.material[0] = true;
    return exitanceOf(stage, session);
  };
  EXPECT_NE(edited(dark).rgba, moved.rgba);
  EXPECT_TRUE(session.scene.changes[0].media.empty());
  EXPECT_EQ(edited(own).rgba, moved.rgba);
  EXPECT_EQ(session.scene.changes[0].media.size(), 1U);
}

// Where the budget leaves surfels larger than the medium asks for, fewer would cost more.
TEST(SessionTest, IsDividedCoarselyWhereSurfelsMayBeLarger) {
  RenderOptions options;
  options.maxSurfels = 50'000;
  EXPECT_EQ(coarselyDivided(options, 40'000).maxSurfels, 10'000);
  EXPECT_EQ(coarselyDivided(options, 50'000).maxSurfels, 50'000);
  EXPECT_EQ(coarselyDivided(options, 10).maxSurfels, 1024);
  options.maxClusters = 500;
  EXPECT_EQ(coarselyDivided(options, 40'000).maxClusters, 500);
  EXPECT_EQ(coarselyDivided(options, 40'000).shadowSize, 512);
  options.shadowSize = 256;
  EXPECT_EQ(coarselyDivided(options, 40'000).shadowSize, 256);
}

}  // namespace
}  // namespace opaline::app::viewer
