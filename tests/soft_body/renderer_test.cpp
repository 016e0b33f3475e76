// A soft body in a renderer: its effect on pictures.

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "opaline/error.h"
#include "opaline/soft_body.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;

class SoftBodyInRendererTest : public RendererTest {
 protected:
  void SetUp() override {
    RendererTest::SetUp();
    scene_ = sceneOf(sphere({0, 0, 0}, 5, 4), marble(), {0, 0, 30}, 9);
    renderer().setScene(scene_);
  }
  const Mesh& mesh() const { return scene_.objects[0].mesh; }
  SoftBody make() const { return {renderer(), 0, mesh().positionsMm, mesh().triangles}; }
  static std::vector<float> places() { return render(smallOptions(), {Aov::Position}).at(0).rgba; }

  Scene scene_;
};

TEST_F(SoftBodyInRendererTest, FramesShowItUntilItIsGone) {
  const std::vector<float> rest = places();
  {
    SoftBody body = make();
    EXPECT_EQ(places(), rest);
    body.grab({0, 5, 0}, 1);
    body.pull({4, 6, 0});
    for (int i = 0; i < 10; ++i) body.step(0.1);
    const std::vector<float> pulled = places();
    EXPECT_GT(*std::max_element(pulled.begin(), pulled.end()),
              *std::max_element(rest.begin(), rest.end()) + 0.5F);
    SoftBody moved = std::move(body);
    moved.release();
    for (int i = 0; i < 100; ++i) moved.step(0.1);
    EXPECT_FALSE(moved.moves());
    EXPECT_EQ(places(), rest);
    moved.grab({0, 5, 0}, 1);
    moved.pull({4, 6, 0});
    moved.step(0.2);
    EXPECT_NE(places(), rest);
  }
  EXPECT_EQ(places(), rest);
}

// Steps are submitted before later frames, and frames under way do not see the next step.
TEST_F(SoftBodyInRendererTest, FramesUnderWayStayAsTheyWere) {
  const auto film = [&](bool together) {
    SoftBody body = make();
    body.grab({0, 5, 0}, 1);
    body.pull({4, 6, 0});
    View view(renderer(), smallOptions());
    std::vector<std::vector<float>> frames;
    Frame frame;
    int underWay = 0;
    for (int i = 0; i < 6; ++i) {
      body.step(0.05);
      view.submit({.aovs = {Aov::Position}});
      ++underWay;
      while (underWay > (together && i < 5 ? 1 : 0)) {
        view.collect(frame);
        frames.push_back(frame.images.at(0).rgba);
        --underWay;
      }
    }
    return frames;
  };
  EXPECT_EQ(film(true), film(false));
}

// A frame's light is reused while the body stands still, and never while it moves.
TEST_F(SoftBodyInRendererTest, LightIsFoundAnewWhileItMoves) {
  View view(renderer(), smallOptions());
  const auto frame = [&](bool reuse) {
    return view.render({.aovs = {Aov::Radiance, Aov::Position}, .reuseLight = reuse}).images;
  };
  SoftBody body = make();
  frame(true);
  for (int i = 0; i < 3; ++i) {
    if (i == 1) {
      body.grab({0, 5, 0}, 1);
      body.pull({4, 6, 0});
    }
    body.step(0.1);
    const std::vector<Image> reused = frame(true);
    const std::vector<Image> fresh = frame(false);
    EXPECT_EQ(reused.at(0).rgba, fresh.at(0).rgba);
    EXPECT_EQ(reused.at(1).rgba, fresh.at(1).rgba);
  }
}

TEST_F(SoftBodyInRendererTest, KnowsItsSceneAndObject) {
  EXPECT_THROW(SoftBody(renderer(), 1, mesh().positionsMm, mesh().triangles), UsageError);
  const std::vector<Vec3> few(mesh().positionsMm.begin(), mesh().positionsMm.end() - 1);
  EXPECT_THROW(SoftBody(renderer(), 0, few, mesh().triangles), UsageError);
  SoftBody body = make();
  renderer().setScene(scene_);
  EXPECT_THROW(body.step(0.1), UsageError);
  const std::vector<float> rest = places();
  Renderer empty;
  EXPECT_THROW(SoftBody(empty, 0, mesh().positionsMm, mesh().triangles), Error);
}

}  // namespace
}  // namespace opaline
