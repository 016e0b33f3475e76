#include "viewer/session/truth_view.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "renderer/shapes.h"

namespace opaline::app::viewer {
namespace {

using Clock = std::chrono::steady_clock;

Session litBall() {
  Session session;
  session.scene = test::sceneOf(test::sphere({0, 0, 0}, 5, 2), test::marble(), {0, 0, 40}, 6);
  session.scene.lighting.directional.push_back({{0.8F, 0, 0.6F}, {1, 2, 3}});
  session.options.transport = Transport::Dipole;
  session.options.antialias = 1;
  session.options.maxSurfels = 1024;
  session.options.shadowSize = 64;
  return session;
}

class TruthViewTest : public testing::Test {
 protected:
  TruthViewTest() { renderer.setScene(session.scene); }

  Session session = litBall();
  Renderer renderer;
  TruthView truth{renderer.vulkanDevice()};
};

/// Whether its end was something new to see.
bool updateUntilItEnds(TruthView& truth) {
  const Clock::time_point deadline = Clock::now() + std::chrono::minutes(5);
  bool isNew = false;
  while (truth.running() && Clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    isNew = truth.update();
  }
  return isNew;
}

// A window that sleeps while it runs, and only then, is to see its end: it may come at any moment
// between two looks.
TEST_F(TruthViewTest, RunsUntilItsEndHasBeenSeen) {
  EXPECT_FALSE(truth.running());
  EXPECT_FALSE(truth.update());
  truth.start(session, renderer, TruthOrder::Method::Integral, 8, 8);
  // Long enough for it to be done meanwhile, wherever a machine is not busy.
  std::this_thread::sleep_for(std::chrono::seconds(1));
  EXPECT_TRUE(truth.running());
  EXPECT_TRUE(updateUntilItEnds(truth));
  EXPECT_TRUE(truth.hasPicture());
  EXPECT_EQ(truth.error(), "");
  EXPECT_FALSE(truth.update());
}

// What another scene's truth was says nothing of a scene.
TEST_F(TruthViewTest, ForgottenItShowsNothing) {
  truth.start(session, renderer, TruthOrder::Method::Integral, 8, 8);
  updateUntilItEnds(truth);
  EXPECT_TRUE(truth.hasPicture());
  EXPECT_TRUE(truth.figures());
  truth.forget();
  EXPECT_FALSE(truth.hasPicture());
  EXPECT_FALSE(truth.figures());
  EXPECT_FALSE(truth.blocks());
  EXPECT_FALSE(truth.latest());
  EXPECT_FALSE(truth.update());
}

TEST_F(TruthViewTest, AFailureIsSomethingToSee) {
  session.positionsMm = {{1, {}}};  // of a body that is not there
  truth.start(session, renderer, TruthOrder::Method::Integral, 8, 8);
  EXPECT_TRUE(updateUntilItEnds(truth));
  EXPECT_NE(truth.error(), "");
  EXPECT_FALSE(truth.hasPicture());
}

TEST_F(TruthViewTest, ItIsOfNowUntilTheSceneIsEdited) {
  truth.start(session, renderer, TruthOrder::Method::Integral, 8, 8);
  session.edits.picture = true;
  truth.follow(session);
  EXPECT_TRUE(truth.isOfNow());
  session.time.seconds = 1;
  truth.follow(session);
  EXPECT_FALSE(truth.isOfNow());
  updateUntilItEnds(truth);
  EXPECT_TRUE(truth.legend().find("when the truth was started") != std::string::npos);
  truth.start(session, renderer, TruthOrder::Method::Integral, 8, 8);
  EXPECT_TRUE(truth.isOfNow());
  session.edits.material = {true};
  truth.follow(session);
  EXPECT_FALSE(truth.isOfNow());
}

TEST_F(TruthViewTest, CancelledItDoesNotRun) {
  truth.start(session, renderer, TruthOrder::Method::Path, 8, 8);
  EXPECT_TRUE(truth.running());
  truth.cancel();
  EXPECT_FALSE(truth.running());
  EXPECT_FALSE(truth.update());
}

}  // namespace
}  // namespace opaline::app::viewer
