#include "viewer/session/session.h"

#include <gtest/gtest.h>

#include "renderer/shapes.h"
#include "viewer/session/playback.h"

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

// Deformers swing once in two seconds.
Session swinging() {
  Session session = sessionAwayFromTheOrigin();
  session.scene.deformers.push_back({DeformerKind::Twist, 1, 2});
  return session;
}

TEST(Session, PlaysWhatItsFilmShows) {
  Session session = swinging();
  fitPlayback(session);
  EXPECT_EQ(session.playback.beginSeconds, 0);
  EXPECT_EQ(session.playback.endSeconds, 2);
  EXPECT_EQ(filmFrames(session).count(), 60U);
  session.film = {12.5, false, 25, 49};
  fitPlayback(session);
  EXPECT_EQ(session.playback.beginSeconds, 2);
  EXPECT_EQ(session.playback.endSeconds, 4);
  EXPECT_EQ(filmFrames(session).perSecond, 12.5);
}

TEST(Session, PlaysARangeAgainAndAgain) {
  Session session = swinging();
  session.film = {10, false, 10, 19};
  fitPlayback(session);
  session.time.seconds = 1;
  session.playback.playing = true;
  playOn(0.75, session);
  EXPECT_NEAR(session.time.seconds, 1.75, 1e-9);
  playOn(0.75, session);
  EXPECT_NEAR(session.time.seconds, 1.5, 1e-9);
  session.playback.loop = false;
  playOn(0.75, session);
  EXPECT_EQ(session.time.seconds, 2);
  EXPECT_FALSE(session.playback.playing);
}

TEST(Session, ThePatternKnowsNoGround) {
  Session session = sessionAwayFromTheOrigin();
  session.edits.material.assign(1, false);
  EXPECT_EQ(complaintAboutPattern(session.scene), "");
  setGround(Ground{}, session);
  EXPECT_NE(complaintAboutPattern(session.scene).find("ground"), std::string::npos);
}

}  // namespace
}  // namespace opaline::app::viewer
