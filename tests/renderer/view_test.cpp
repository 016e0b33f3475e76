#include <gtest/gtest.h>

#include <vulkan/vulkan.h>

#include <cstddef>
#include <vector>

#include "opaline/error.h"
#include "opaline/vulkan.h"
#include "renderer/renderer_fixture.h"
#include "renderer/wobbly_ball.h"

namespace opaline::test {
namespace {

class ViewTest : public RendererTest {
 protected:
  /// Makes a frame that leaves its picture on the device.
  static VkImage show(View& view) {
    view.render({.aovs = {}, .onDevice = true});
    return view.picture().image;
  }
  /// The validation layer complains of images that are gone.
  static void touch(VkImage image) {
    VkMemoryRequirements requirements{};
    vkGetImageMemoryRequirements(renderer().vulkanDevice().device, image, &requirements);
    EXPECT_GT(requirements.size, 0U);
  }
};

TEST_F(ViewTest, PictureStaysOnTheDevice) {
  RenderOptions options = smallOptions();
  options.width = 40;
  renderer().setScene(wobblyBall());
  View view(renderer(), options);
  view.submit({.aovs = {Aov::Exitance}, .onDevice = true});
  const DeviceImage image = view.picture();
  EXPECT_NE(image.view, VK_NULL_HANDLE);
  EXPECT_EQ(image.extent.width, 40U);
  EXPECT_EQ(image.extent.height, 64U);
  EXPECT_EQ(image.layout, VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL);
  Frame frame;
  view.collect(frame);
  ASSERT_EQ(frame.images.size(), 1U);
  expectSame(frame.images, render(options, {Aov::Exitance}));
  view.render();
  EXPECT_THROW(view.picture(), UsageError);
}

// Each keeps its own division and the light that its surfels hold.
TEST_F(ViewTest, ThoseThatDivideTheSceneOtherwiseMayTakeTurns) {
  renderer().setScene(wobblyBall());
  RenderOptions coarse = optionsOf(methods[0]);
  coarse.maxClusters = 64;
  const std::vector<Image> fineAlone = render(optionsOf(methods[0]), asked());
  const std::vector<Image> coarseAlone = render(coarse, asked());
  View fine(renderer(), optionsOf(methods[0]));
  View few(renderer(), coarse);
  for (int turn = 0; turn < 2; ++turn) {
    expectSame(fine.render({.aovs = asked(), .reuseLight = true}).images, fineAlone);
    EXPECT_EQ(runs(fine, "shadow"), turn == 0);
    expectSame(few.render({.aovs = asked(), .reuseLight = true}).images, coarseAlone);
    EXPECT_EQ(runs(few, "shadow"), turn == 0);
  }
  EXPECT_GT(fine.report().clusters, few.report().clusters);
}

// Whatever other views need of the scene is made, and whatever scene is set.
TEST_F(ViewTest, PictureStaysAsLongAsItsViewHasThatSize) {
  renderer().setScene(wobblyBall());
  View tree(renderer(), optionsOf(methods[1]));
  View paper(renderer(), optionsOf(methods[2]));
  View boundary(renderer(), optionsOf(methods[0]));
  const VkImage ofTree = show(tree);
  const VkImage ofPaper = show(paper);  // needs a map
  touch(ofTree);
  EXPECT_NE(ofPaper, ofTree);
  renderer().setScene(wobblyBall());
  touch(ofTree);
  touch(ofPaper);
  EXPECT_NE(show(boundary), ofTree);  // needs clusters
  EXPECT_EQ(show(tree), ofTree);
  EXPECT_EQ(show(paper), ofPaper);
  paper.setOptions(optionsOf(methods[1]));
  EXPECT_EQ(show(paper), ofPaper);
}

TEST_F(ViewTest, OptionsMayChangeFromFrameToFrame) {
  const Scene scene = wobblyBall();
  std::vector<RenderOptions> all;
  for (const Method& method : methods) all.push_back(optionsOf(method));
  all.push_back(all[0]);
  all.back().width = 48;
  all.push_back(all.back());
  all.back().roughness = 0.6F;
  all.push_back(all.back());
  all.back().shadowSize = 64;
  all.push_back(optionsOf(methods[2]));
  all.back().pattern.nearRings = 2;
  all.push_back(all.back());
  all.back().dsmSize = 64;
  std::vector<std::vector<Image>> alone;
  for (const RenderOptions& options : all) {
    renderer().setScene(scene);
    alone.push_back(View(renderer(), options).render({.aovs = asked()}).images);
  }
  View view(renderer());
  for (std::size_t round = 0; round < 2; ++round)
    for (std::size_t i = 0; i < all.size(); ++i) {
      SCOPED_TRACE(i);
      view.setOptions(all[i]);
      expectSame(view.render({.aovs = asked(), .reuseLight = true}).images, alone[i]);
    }
}

TEST_F(ViewTest, HasItsOwnCameraOrTheScenes) {
  Scene scene = wobblyBall();
  View view(renderer(), smallOptions());
  Camera aside = scene.camera;
  aside.positionMm[1] += 5;
  const std::vector<Image> fromScene = render(scene, smallOptions(), asked());
  view.setCamera(aside);
  const std::vector<Image> fromAside = view.render({.aovs = asked()}).images;
  EXPECT_NE(fromAside[0].rgba, fromScene[0].rgba);
  expectSame(render(smallOptions(), asked()), fromScene);
  view.setCamera(std::nullopt);
  expectSame(view.render({.aovs = asked()}).images, fromScene);
  aside.targetMm = aside.positionMm;
  EXPECT_THROW(view.setCamera(aside), Error);
  expectSame(view.render({.aovs = asked()}).images, fromScene);
}

// More frames than one view has of them, and each as if it were alone.
TEST_F(ViewTest, FramesOfSeveralViewsAreUnderWayAtOnce) {
  Scene scene = wobblyBall();
  scene.deformers.push_back({DeformerKind::Wobble, 0.1F, 1});
  renderer().setScene(scene);
  std::vector<View> views;
  std::vector<std::vector<Image>> alone;
  for (const Method& method : methods) views.emplace_back(renderer(), optionsOf(method));
  const auto timeOf = [](std::size_t i) { return SceneTime{.seconds = 0.1 * double(i)}; };
  for (std::size_t i = 0; i < 2 * views.size(); ++i) {
    renderer().setTime(timeOf(i));
    alone.push_back(views[i % views.size()].render({.aovs = asked()}).images);
  }
  for (std::size_t i = 0; i < alone.size(); ++i) {
    renderer().setTime(timeOf(i));
    views[i % views.size()].submit({.aovs = asked()});
  }
  Frame frame;
  for (std::size_t i = 0; i < alone.size(); ++i) {
    views[i % views.size()].collect(frame);
    expectSame(frame.images, alone[i]);
  }
}

// With frames under way, which nobody will collect.
TEST_F(ViewTest, MayGoAtAnyTime) {
  renderer().setScene(wobblyBall());
  const std::vector<Image> before = render(smallOptions(), asked());
  for (int i = 0; i < 4; ++i) {
    View view(renderer(), smallOptions());
    for (int k = 0; k < View::framesInFlight; ++k) view.submit({.onDevice = true});
    if (i % 2 == 0) renderer().setScene(wobblyBall());
  }
  expectSame(render(smallOptions(), asked()), before);
}

TEST_F(ViewTest, MemoryIsGivenBack) {
  const auto peakOf = [](int views) {
    Renderer fresh(sharedRenderer().options());
    fresh.setScene(wobblyBall());
    double peak = 0;
    for (int i = 0; i < views; ++i)
      peak = View(fresh, smallOptions()).render().report.peakMemoryMegabytes;
    return peak;
  };
  EXPECT_LT(peakOf(6), 1.5 * peakOf(1));
}

TEST_F(ViewTest, ReportIsOfItsOwnFrames) {
  renderer().setScene(wobblyBall());
  View view(renderer(), smallOptions());
  EXPECT_THROW(view.report(), UsageError);
  view.render();
  EXPECT_EQ(view.report().clusters, 0U);
  View(renderer(), optionsOf(methods[0])).render();
  EXPECT_EQ(view.report().transport, Transport::Dipole);
  renderer().setScene(wobblyBall());
  EXPECT_THROW(view.report(), UsageError);
}

}  // namespace
}  // namespace opaline::test
