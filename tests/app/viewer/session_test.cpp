#include "viewer/session/session.h"

#include <gtest/gtest.h>

#include "renderer/shapes.h"

namespace opaline::app::viewer {
namespace {

/// A box of 10 mm each way about (100, 200, -50).
Session sessionAwayFromTheOrigin() {
  Session session;
  session.scene =
      test::sceneOf(test::box({100, 200, -50}, {5, 5, 5}, 1), test::marble(), {100, 200, -10}, 9);
  measure(session.scene, session);
  return session;
}

TEST(Session, PlacesInFilesAreRelativeToTheMiddleOfAllObjects) {
  const Session session = sessionAwayFromTheOrigin();
  EXPECT_EQ(placeInFile({103, 190, -50}, session), (Vec3{3, -10, 0}));
  EXPECT_EQ(placeInScene({3, -10, 0}, session), (Vec3{103, 190, -50}));
}

// A ground is no such object, however far it reaches.
TEST(Session, PanelsAndSavedFilesGiveTheSamePlaces) {
  Session session = sessionAwayFromTheOrigin();
  session.edits.material.assign(1, false);
  setGround(Ground{{0.5F, 0.5F, 0.5F}, 180.0F}, session);
  measure(session.scene, session);
  const SceneDescription saved = describe(session.scene, session.source, {});
  ASSERT_TRUE(saved.ground);
  EXPECT_FLOAT_EQ(*saved.ground->heightMm, -20);
  EXPECT_FLOAT_EQ(placeInFile({0, 180, 0}, session)[1], -20);
  EXPECT_EQ(saved.centreMm, session.centreMm);
}

}  // namespace
}  // namespace opaline::app::viewer
