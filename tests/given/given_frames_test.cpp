#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <vector>

#include "given/given_frames_fixture.h"
#include "opaline/error.h"

namespace opaline::test {
namespace {

TEST_F(GivenFramesTest, WhatIsRecordedIsWhatIsRendered) {
  const std::vector<Aov> aovs{Aov::Radiance, Aov::Exitance, Aov::Normal};
  View view(renderer(), options());
  for (int i = 0; i < 4; ++i) {
    renderer().setTime({.seconds = 0.1 * i});
    const VkCommandBuffer commands = engine().begin();
    const TimelinePoint finished = engine().nextPoint();
    view.record({.commands = commands, .finished = finished}, {.aovs = aovs});
    engine().submit(commands, finished);
    Frame frame;
    view.collect(frame);
    expectSame(frame.images, renderer().render(options(), aovs).images);
  }
}

TEST_F(GivenFramesTest, AFrameThatWasPreparedIsRecordedWithoutSubmissions) {
  for (const Method& method : methods) {
    SCOPED_TRACE(method.name);
    View view(renderer(), optionsOf(method));
    const FrameOrder order{.aovs = {}, .onDevice = true};
    view.prepare(order);
    const int before = Engine::submissions();
    for (int i = 0; i < 8; ++i) runFrame(view, {}, order);  // nobody collects them
    EXPECT_EQ(Engine::submissions(), before);
    EXPECT_NE(view.picture().image, VK_NULL_HANDLE);
    // A frame is kept once it is like the one before in its place.
    Frame frame;
    view.collect(frame);
    view.collect(frame);
    EXPECT_EQ(view.report().recordings, 0U);
    expectSame(view.render().images, renderer().render(optionsOf(method)).images);
  }
}

TEST_F(GivenFramesTest, SubmittedFramesWaitForPointsAndSignalThem) {
  View view(renderer(), options());
  const TimelinePoint go = engine().nextPoint();
  const TimelinePoint done = engine().nextPoint();
  view.submit({.waits = {&go, 1}, .signals = {&done, 1}}, {});
  std::uint64_t value = 0;
  vkGetSemaphoreCounterValue(engine().device(), engine().timeline(), &value);
  EXPECT_LT(value, go.value);
  engine().signal(go);
  engine().waitFor(done);
  Frame frame;
  view.collect(frame);
  expectSame(frame.images, renderer().render(options()).images);
}

// Numbers as View::collect has them, but for rounding of the depth; far from the origin too.
TEST_F(GivenFramesTest, VariablesOnTheDeviceAreThoseOfTheHost) {
  const std::vector<Aov> aovs{Aov::Exitance, Aov::Irradiance, Aov::Position,    Aov::Normal,
                              Aov::Depth,    Aov::Object,     Aov::Evaluations, Aov::Surfels};
  const std::vector<Aov> onDevice{Aov::Irradiance, Aov::Position,    Aov::Normal,  Aov::Depth,
                                  Aov::Object,     Aov::Evaluations, Aov::Surfels, Aov::Exitance};
  for (const float offsetMm : {0.F, 65536.F}) {
    SCOPED_TRACE(offsetMm);
    Scene moved = scene_;
    for (Vec3& position : moved.objects[0].mesh.positionsMm) position[0] += offsetMm;
    moved.camera.positionMm[0] += offsetMm;
    moved.camera.targetMm[0] += offsetMm;
    renderer().setScene(moved);
    View view(renderer(), options());
    view.submit({.aovs = aovs, .aovsOnDevice = onDevice});
    Frame frame;
    view.collect(frame);
    for (std::size_t i = 0; i < aovs.size(); ++i) {
      SCOPED_TRACE(static_cast<int>(aovs[i]));
      const std::vector<float> left = engine().read(view.picture(aovs[i]));
      ASSERT_EQ(left.size(), frame.images[i].rgba.size());
      for (std::size_t j = 0; j < left.size(); ++j) {
        const float error = aovs[i] == Aov::Depth ? 1e-5F * std::abs(left[j]) : 0;
        ASSERT_NEAR(left[j], frame.images[i].rgba[j], error);
      }
    }
    EXPECT_THROW(static_cast<void>(view.picture(Aov::Radiance)), UsageError);
    view.submit({.aovs = {}, .aovsOnDevice = {Aov::Radiance}});
    EXPECT_EQ(view.picture(Aov::Radiance).extent.width, size);
    EXPECT_THROW(static_cast<void>(view.picture(Aov::Normal)), UsageError);
    EXPECT_THROW(view.submit({.aovs = {}, .aovsOnDevice = {Aov::DsmArea}}), UsageError);
  }
}

// The caller's wall stands at the middle of the ball: of what lies before it the ball is seen, with
// its own depth; the wall keeps the rest.
TEST_F(GivenFramesTest, TheBodyIsComposedWithTheCallersDrawingByDepth) {
  const double distance =
      length(toVector(scene_.camera.positionMm) - toVector(scene_.camera.targetMm));
  const Engine::Target color = engine().makeTarget(VK_FORMAT_R32G32B32A32_SFLOAT, {size, size});
  const Engine::Target depth = engine().makeTarget(VK_FORMAT_D32_SFLOAT, {size, size});
  RenderOptions wanted = options();
  wanted.antialias = 1;
  for (const bool reversed : {false, true}) {
    std::vector<std::size_t> seen;  // pixels of the ball
    for (const double wallMm : {distance - 20, distance - 3, distance + 20}) {
      SCOPED_TRACE(testing::Message() << (reversed ? "reversed, wall at " : "wall at ") << wallMm);
      View view(renderer(), wanted);
      view.setCamera(matrices(reversed));
      const std::vector<Image> own = view.render({.aovs = {Aov::Radiance, Aov::Depth}}).images;
      const auto wallDepth = static_cast<float>(depthAt(wallMm, reversed));
      engine().run([&](VkCommandBuffer commands) {
        Engine::clear(commands, color, {{0.25F, 0.5F, 0.75F, 1}}, depth, wallDepth);
      });
      const Composition over{
          .color = {color.image, color.view, color.format, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL},
          .depth = {depth.image, depth.view, depth.format, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL},
          .radianceScale = 2};
      runFrame(view, {.over = &over}, {.aovs = {Aov::Depth}});
      Frame frame;
      view.collect(frame);
      EXPECT_EQ(frame.images[0].rgba, own[1].rgba);
      const std::vector<float> colors = engine().read(color);
      const std::vector<float> depths = engine().read(depth);
      std::size_t ball = 0;
      for (std::size_t i = 0; i < depths.size(); ++i) {
        const double distanceMm = static_cast<double>(own[1].rgba[4 * i]);
        const bool isBall = own[0].rgba[4 * i + 3] > 0 && distanceMm < wallMm;
        if (isBall) ++ball;
        EXPECT_NEAR(depths[i], isBall ? depthAt(distanceMm, reversed) : depthAt(wallMm, reversed),
                    2e-6);
        EXPECT_NEAR(colors[4 * i], isBall ? 2 * own[0].rgba[4 * i] : 0.25F, 1e-5F);
        EXPECT_NEAR(colors[4 * i + 2], isBall ? 2 * own[0].rgba[4 * i + 2] : 0.75F, 1e-5F);
      }
      seen.push_back(ball);
    }
    EXPECT_EQ(seen[0], 0U);
    EXPECT_GT(seen[1], 0U);
    EXPECT_GT(seen[2], seen[1]);
  }
}

TEST_F(GivenFramesTest, TargetsMayHaveSeveralSamples) {
  constexpr VkSampleCountFlagBits four = VK_SAMPLE_COUNT_4_BIT;
  const VkExtent2D extent{size, size};
  const Engine::Target plain = engine().makeTarget(VK_FORMAT_R32G32B32A32_SFLOAT, extent);
  const Engine::Target plainDepth = engine().makeTarget(VK_FORMAT_D32_SFLOAT, extent);
  const Engine::Target color = engine().makeTarget(VK_FORMAT_R32G32B32A32_SFLOAT, extent, four);
  const Engine::Target depth = engine().makeTarget(VK_FORMAT_D32_SFLOAT, extent, four);
  const double distance =
      length(toVector(scene_.camera.positionMm) - toVector(scene_.camera.targetMm));
  const auto wallDepth = static_cast<float>(depthAt(distance - 3, true));
  View view(renderer(), options());
  view.setCamera(matrices(true));
  const auto composed = [&](const Engine::Target& onto, const Engine::Target& tested,
                            VkSampleCountFlagBits samples) {
    engine().run([&](VkCommandBuffer commands) {
      Engine::clear(commands, onto, {{0.25F, 0.5F, 0.75F, 1}}, tested, wallDepth);
    });
    const Composition over{.color = {.image = onto.image,
                                     .view = onto.view,
                                     .format = onto.format,
                                     .samples = samples},
                           .depth = {.image = tested.image,
                                     .view = tested.view,
                                     .format = tested.format,
                                     .samples = samples}};
    runFrame(view, {.over = &over}, {.aovs = {}});
  };
  composed(plain, plainDepth, VK_SAMPLE_COUNT_1_BIT);
  const std::vector<float> expected = engine().read(plain);
  composed(color, depth, four);
  engine().resolve(color, plain);
  EXPECT_EQ(engine().read(plain), expected);
  EXPECT_NE(*std::max_element(expected.begin(), expected.end()), 1);

  Composition over{
      .color = {.image = color.image, .view = color.view, .format = color.format, .samples = four},
      .depth = {depth.image, depth.view, depth.format}};
  EXPECT_THROW(view.submit({.outputs = {.over = &over}}, {}), UsageError);
  over.color.samples = static_cast<VkSampleCountFlagBits>(3);
  EXPECT_THROW(view.submit({.outputs = {.over = &over}}, {}), UsageError);
}

TEST_F(GivenFramesTest, DepthOfTheCallersNeedsItsMatrices) {
  const Engine::Target color = engine().makeTarget(VK_FORMAT_R8G8B8A8_UNORM, {size, size});
  const Engine::Target depth = engine().makeTarget(VK_FORMAT_D32_SFLOAT, {size, size});
  const Composition over{.color = {color.image, color.view, color.format},
                         .depth = {depth.image, depth.view, depth.format}};
  View view(renderer(), options());
  EXPECT_THROW(view.submit({.outputs = {.over = &over}}, {}), UsageError);
  EXPECT_THROW(view.record({}, {}), UsageError);
}

TEST_F(GivenFramesTest, ExitanceOfVerticesIsAsItIsSeen) {
  RenderOptions wanted = options();
  wanted.site = Site::Vertex;
  wanted.antialias = 1;
  View view(renderer(), wanted);
  const std::size_t vertices = scene_.objects[0].mesh.positionsMm.size();
  const Engine::HostBuffer buffer =
      engine().makeBuffer(16 * vertices + 32, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  const DeviceExitance into{.object = 0, .buffer = buffer.buffer, .offsetBytes = 32};
  runFrame(view, {.exitances = {&into, 1}}, {.aovs = {}, .exitance = true});
  const DeviceBuffer own = view.exitance(0);
  EXPECT_EQ(own.bytes, 16 * vertices);
  EXPECT_THROW(static_cast<void>(view.exitance(1)), UsageError);
  const Engine::HostBuffer copy =
      engine().makeBuffer(16 * vertices, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  engine().run([&](VkCommandBuffer commands) {
    const VkBufferCopy region{own.offsetBytes, 0, own.bytes};
    vkCmdCopyBuffer(commands, own.buffer, copy.buffer, 1, &region);
  });
  std::vector<float> ofCopy(4 * vertices);
  std::vector<float> ofCaller(4 * vertices);
  std::memcpy(ofCopy.data(), copy.mapped, 16 * vertices);
  std::memcpy(ofCaller.data(), buffer.mapped + 32, 16 * vertices);
  EXPECT_EQ(ofCopy, ofCaller);
  // Each pixel sees a mean of its triangle's corners.
  const Image seen = view.render({.aovs = {Aov::Exitance}}).images[0];
  float least = ofCopy[0];
  float most = ofCopy[0];
  for (std::size_t v = 0; v < vertices; ++v) {
    least = std::min(least, ofCopy[4 * v]);
    most = std::max(most, ofCopy[4 * v]);
  }
  EXPECT_GT(most, 2 * least);
  for (std::size_t i = 0; i < seen.rgba.size(); i += 4) {
    if (seen.rgba[i + 3] == 0) continue;
    EXPECT_GE(seen.rgba[i], 0.99F * least);
    EXPECT_LE(seen.rgba[i], 1.01F * most);
  }
  wanted.site = Site::Fragment;
  view.setOptions(wanted);
  EXPECT_THROW(view.submit({.outputs = {.exitances = {&into, 1}}}, {}), UsageError);
  EXPECT_THROW(view.submit({.exitance = true}), UsageError);
}

// Nothing is destroyed that frames under way use, which the validation layer would report.
TEST_F(GivenFramesTest, ViewsMayChangeSizeAndGoWhileFramesAreUnderWay) {
  const Engine::Target color = engine().makeTarget(VK_FORMAT_R16G16B16A16_SFLOAT, {size, size});
  const Engine::Target depth = engine().makeTarget(VK_FORMAT_D32_SFLOAT, {size, size});
  engine().run([&](VkCommandBuffer commands) {
    Engine::clear(commands, color, {{0, 0, 0, 0}}, depth, 0);
  });
  const Composition over{.color = {color.image, color.view, color.format}};
  std::optional<View> view;
  TimelinePoint last;
  for (int i = 0; i < 6; ++i) {
    if (i % 3 == 0) view.emplace(renderer(), options());
    RenderOptions wanted = options();
    if (i % 2 == 1) wanted.width = wanted.height = 24;
    view->setOptions(wanted);
    const VkCommandBuffer commands = engine().begin();
    last = engine().nextPoint();
    FrameRecording recording{.commands = commands, .finished = last};
    if (i % 2 == 0) recording.outputs.over = &over;
    view->record(recording, {.aovs = {}, .onDevice = true});
    engine().submit(commands, last);
    if (i == 4) renderer().setScene(scene_);
  }
  view.reset();
  engine().waitFor(last);
}

}  // namespace
}  // namespace opaline::test
