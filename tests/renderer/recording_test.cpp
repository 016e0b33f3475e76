#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <vector>

#include "opaline/vulkan.h"
#include "renderer/renderer_fixture.h"
#include "renderer/wobbly_ball.h"

namespace opaline::test {
namespace {

class FrameRecordingTest : public RendererTest {
 protected:
  void SetUp() override {
    RendererTest::SetUp();
    scene_ = wobblyBall();
    scene_.deformers.push_back({DeformerKind::Wobble, 0.1F, 1});
    renderer().setScene(scene_);
  }

  /// How often each frame of a film is recorded, with two of them under way.
  static std::vector<std::uint32_t> recordingsOf(View& view, int frames,
                                                 const std::function<void(int)>& before) {
    std::vector<std::uint32_t> recordings;
    Frame frame;
    const auto collect = [&] {
      view.collect(frame);
      recordings.push_back(view.report().recordings);
    };
    for (int i = 0; i < frames; ++i) {
      before(i);
      if (i >= View::framesInFlight) collect();
      view.submit();
    }
    while (recordings.size() < static_cast<std::size_t>(frames)) collect();
    return recordings;
  }

  Scene scene_;
};

// The first frame gets its images from elsewhere than the others, so the first slot is recorded
// twice. A frame has two parts.
const std::vector<std::uint32_t> ofFilm{2, 2, 2, 0, 0, 0, 0, 0};

TEST_F(FrameRecordingTest, AFilmIsRecordedOncePerSlot) {
  for (const Method& method : methods) {
    SCOPED_TRACE(method.name);
    View view(renderer(), optionsOf(method));
    const auto change = [&](int i) {
      const auto step = static_cast<float>(i);
      renderer().setTime({.seconds = 0.1 * i});
      Camera camera = scene_.camera;
      camera.positionMm[0] += step;
      view.setCamera(camera);
      Lighting lighting = scene_.lighting;
      lighting.directional[0].irradiance = {1 + step, 1, 1};
      lighting.directional[0].directionToLight[0] = 0.1F * step;
      renderer().setLighting(lighting);
    };
    const std::vector<std::uint32_t> recordings = recordingsOf(view, 8, change);
    for (std::size_t i = 0; i < recordings.size(); ++i) EXPECT_LE(recordings[i], ofFilm[i]) << i;
  }
}

// A frame that is kept must equal what would be recorded.
TEST_F(FrameRecordingTest, KeptFramesAreWhatNewOnesWouldBe) {
  for (const Method& method : methods) {
    SCOPED_TRACE(method.name);
    constexpr int frames = 6;
    const auto setTime = [&](int i) { renderer().setTime({.seconds = 0.1 * i}); };
    std::vector<std::vector<Image>> alone;
    for (int i = 0; i < frames; ++i) {
      setTime(i);
      View view(renderer(), optionsOf(method));
      alone.push_back(view.render({.aovs = asked()}).images);
    }
    View kept(renderer(), optionsOf(method));
    for (int i = 0; i < frames; ++i) {
      setTime(i);
      expectSame(kept.render({.aovs = asked()}).images, alone[static_cast<std::size_t>(i)]);
    }
    EXPECT_EQ(kept.report().recordings, 0U);
  }
}

TEST_F(FrameRecordingTest, PositionsThatAreGivenAreRecordedApart) {
  const std::vector<Vec3> positions = scene_.objects[0].mesh.positionsMm;
  View view(renderer(), optionsOf(methods[0]));
  const std::vector<std::uint32_t> recordings =
      recordingsOf(view, 8, [&](int) { renderer().replacePositions(0, positions); });
  for (std::size_t i = 3; i < recordings.size(); ++i) EXPECT_LE(recordings[i], 1U) << i;
}

// Each change, after enough frames that all is kept, gives the picture of a fresh view. So does
// changing back.
TEST_F(FrameRecordingTest, EveryChangeIsSeen) {
  using Change = std::function<void(RenderOptions&, FrameOrder&)>;
  const std::vector<Change> changes{
      [](RenderOptions& o, FrameOrder&) { o.transport = Transport::Dipole; },
      [](RenderOptions& o, FrameOrder&) { o.transport = Transport::BetterDipole; },
      [](RenderOptions& o, FrameOrder&) { o.sum = Sum::All; },
      [](RenderOptions& o, FrameOrder&) { o.site = Site::Fragment; },
      [](RenderOptions& o, FrameOrder&) { o.site = Site::Auto; },
      [](RenderOptions& o, FrameOrder&) { o.tolerance = 0.1F; },
      [](RenderOptions& o, FrameOrder&) { o.tolerance = 0.001F; },
      [](RenderOptions& o, FrameOrder&) { o.bounces = 0; },
      [](RenderOptions& o, FrameOrder&) { o.bounces = 3; },
      [](RenderOptions& o, FrameOrder&) { o.antialias = 1; },
      [](RenderOptions& o, FrameOrder&) { o.antialias = 8; },
      [](RenderOptions& o, FrameOrder&) { o.specular = false; },
      [](RenderOptions& o, FrameOrder&) { o.roughness = 0.7F; },
      [](RenderOptions& o, FrameOrder&) { o.width = 40; },
      [](RenderOptions& o, FrameOrder&) { o.shadowSize = 64; },
      [](RenderOptions& o, FrameOrder&) { o.maxSurfels = 2048; },
      [](RenderOptions& o, FrameOrder&) { o.maxClusters = 128; },
      [](RenderOptions& o, FrameOrder& f) {
        o.treeLevel = 2;
        f.aovs = {Aov::Surfels, Aov::Radiance};
      },
      [](RenderOptions&, FrameOrder& f) {
        f.aovs = {Aov::Depth, Aov::Irradiance, Aov::Normal};
      },
      [](RenderOptions&, FrameOrder& f) { f.onDevice = true; },
      [](RenderOptions&, FrameOrder& f) { f.reuseLight = true; }};
  const RenderOptions plain = optionsOf(methods[0]);
  View view(renderer(), plain);
  const std::vector<Image> unchanged = view.render({.aovs = asked()}).images;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    SCOPED_TRACE(i);
    RenderOptions options = plain;
    FrameOrder order{.aovs = asked()};
    changes[i](options, order);
    const std::vector<Image> alone = View(renderer(), options).render(order).images;
    view.setOptions(options);
    for (int frame = 0; frame < 4; ++frame) expectSame(view.render(order).images, alone);
    EXPECT_EQ(view.report().recordings, 0U);
    view.setOptions(plain);
    expectSame(view.render({.aovs = asked()}).images, unchanged);
  }
}

// One point light has as many shadow maps as six directional lights.
TEST_F(FrameRecordingTest, OtherLightsAreSeen) {
  Lighting six;
  for (int i = 0; i < 6; ++i)
    six.directional.push_back({{0.3F * static_cast<float>(i), 1, 1}, {1, 1, 1}});
  Lighting one;
  one.points.push_back({{0, 12, 12}, {900, 900, 900}});
  Lighting none;
  none.ambient = {1, 1, 1};
  View view(renderer(), optionsOf(methods[0]));
  for (int round = 0; round < 2; ++round)
    for (const Lighting& lighting : {six, one, none, scene_.lighting}) {
      renderer().setLighting(lighting);
      const std::vector<Image> fresh =
          View(renderer(), optionsOf(methods[0])).render({.aovs = asked()}).images;
      for (int i = 0; i < 3; ++i) expectSame(view.render({.aovs = asked()}).images, fresh);
    }
}

// The report on a default frame of a ball whose triangles are halved `levels` times.
RenderReport reportOf(const Medium& medium, int levels) {
  Scene scene = sceneOf(sphere({0, 0, 0}, 6, levels), medium, {0, 3, 24}, 7);
  scene.lighting.directional = {{{0.6F, 0, 0.8F}, {1, 1, 1}}, {{-0.6F, 0, -0.8F}, {1, 1, 1}}};
  scene.lighting.ambient = {0.2F, 0.2F, 0.2F};
  scene.deformers.push_back({DeformerKind::Wobble, 0.1F, 1});
  Renderer& renderer = *sharedRenderer().renderer;
  renderer.setScene(scene);
  RenderOptions options;
  options.width = options.height = 32;
  options.maxSurfels = 16384;
  options.maxClusters = 1024;
  View view(renderer, options);
  for (int i = 0; i < 3; ++i) {
    renderer.setTime({.seconds = 0.1 * i});
    view.render();
  }
  return view.report();
}

// Each command waits for others or is waited for, some microseconds on a GPU. A default frame has
// at most 120 of each kind. Summing at fragments takes three rounds with ten more. Mesa's software
// device has one more, as it sends the rays of clusters in two parts (gpu::WorkGroups::loopsEnd).
TEST_F(FrameRecordingTest, ADefaultFrameHasFewCommands) {
  for (const Medium& medium : {marble(), skin()}) {
    const RenderReport atVertices = reportOf(medium, 5);
    EXPECT_LE(atVertices.dispatches, 121U);
    EXPECT_LE(atVertices.barriers, 121U);
    EXPECT_GT(atVertices.barriers, 50U);
    const RenderReport atFragments = reportOf(medium, 3);
    EXPECT_LE(atFragments.dispatches, 131U);
    EXPECT_LE(atFragments.barriers, 131U);
  }
}

// Boxes of 1 mm, 2 mm apart.
RenderReport reportOfBoxes(int edge) {
  Scene scene = sceneOf(box({0, 0, 0}, {0.5F, 0.5F, 0.5F}, 1), marble(), {0, 0, 40}, 20);
  const Object first = scene.objects.front();
  scene.objects.clear();
  for (int i = 0; i < edge * edge * edge; ++i) {
    const Vec3 place{static_cast<float>(i % edge), static_cast<float>(i / edge % edge),
                     static_cast<float>(i / (edge * edge))};
    scene.objects.push_back(first);
    for (Vec3& corner : scene.objects.back().mesh.positionsMm)
      for (std::size_t axis = 0; axis < 3; ++axis) corner[axis] += 2 * place[axis];
  }
  Renderer& renderer = *sharedRenderer().renderer;
  renderer.setScene(scene);
  RenderOptions options;
  options.width = options.height = 16;
  options.shadowSize = 64;
  options.maxSurfels = 16384;
  View view(renderer, options);
  return view.render().report;
}

// The room in work lists depends on each body, not on the number of bodies.
TEST_F(FrameRecordingTest, ManyBodiesTakeNoMoreThanFewer) {
  const RenderReport fewer = reportOfBoxes(7);
  const RenderReport many = reportOfBoxes(11);
  EXPECT_EQ(many.transport, Transport::Boundary);
  EXPECT_GE(many.clusters, 1331U);
  EXPECT_LE(many.dispatches, fewer.dispatches);
  EXPECT_LE(many.barriers, fewer.barriers);
}

}  // namespace
}  // namespace opaline::test
