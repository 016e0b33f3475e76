#include "viewer/picture/poke.h"

#include <gtest/gtest.h>

#include "renderer/shapes.h"

namespace opaline::app::viewer {
namespace {

class PokeTest : public testing::Test {
 protected:
  PokeTest() {
    session.scene = test::sceneOf(test::sphere({0, 0, 0}, 5, 2), test::marble(), {0, 0, 40}, 6);
    session.diagonalMm = 17;
    renderer.setScene(session.scene);
  }

  bool grab() { return poke.grab(session, projection().through({50, 50})); }
  Projection projection() const { return {session.scene.camera, {0, 0, 100, 100}}; }

  Session session;
  Renderer renderer;
  Poke poke{renderer};
};

// A picture a second is what a slow device makes: the swing goes on in the time of the hand.
TEST_F(PokeTest, ComesToRestWithinSecondsHoweverSlowPicturesCome) {
  ASSERT_TRUE(grab());
  poke.pull(projection(), {80, 40});
  EXPECT_TRUE(poke.step());
  poke.advance(1);
  EXPECT_TRUE(poke.step());
  EXPECT_TRUE(poke.moves());
  poke.release();
  int seconds = 0;
  for (; poke.moves() && seconds < 60; ++seconds) {
    poke.advance(1);
    poke.step();
  }
  EXPECT_GT(seconds, 1) << "it swings";
  EXPECT_LE(seconds, 10);
  EXPECT_TRUE(poke.step()) << "back in its own shape, which is to be drawn";
  EXPECT_FALSE(poke.holdsBody());
}

// Nothing is asked of the device until its next picture begins.
TEST_F(PokeTest, WhatIsLetGoBeforeTheNextPictureWasNeverHeld) {
  ASSERT_TRUE(grab());
  EXPECT_TRUE(poke.moves());
  poke.release();
  EXPECT_FALSE(poke.moves());
  EXPECT_FALSE(poke.step());
}

TEST_F(PokeTest, BesideTheBodyThereIsNothingToHold) {
  EXPECT_FALSE(poke.grab(session, projection().through({1, 1})));
  EXPECT_FALSE(poke.step());
}

}  // namespace
}  // namespace opaline::app::viewer
