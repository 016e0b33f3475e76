// Frames recorded for an engine allocate nothing once they have warmed up, whatever they leave on
// its device. The validation layer is off, since its memory would be counted too.

#include <gtest/gtest.h>

#include <cstring>

#include "allocations.h"
#include "given/given_frames_fixture.h"

namespace opaline::test {
namespace {

class GivenAllocationTest : public GivenFramesTest {
 protected:
  GivenAllocationTest() : GivenFramesTest(false) {}

  /// Allocations of frames after the warm-up. Before each, time and camera change, from camera_ to
  /// a perspective one and back.
  std::size_t allocationsOf(View& view, const DeviceOutputs& outputs, const FrameOrder& order) {
    constexpr int warmUp = 4;
    constexpr int steady = 6;
    std::size_t found = 0;
    for (int i = 0; i < warmUp + steady; ++i) {
      CameraMatrices camera = i % 2 == 0 ? camera_ : matrices(true);
      camera.jitterPixels = {0.1F * static_cast<float>(i % 3), -0.2F};
      const FrameRecording recording{
          .commands = engine().begin(), .finished = engine().nextPoint(), .outputs = outputs};
      const std::size_t before = allocations();
      renderer().setTime({.seconds = 0.1 * i});
      view.setCamera(camera);
      view.prepare(order);
      view.record(recording, order);
      if (i >= warmUp) found += allocations() - before;
      engine().submit(recording.commands, recording.finished);
      engine().waitFor(recording.finished);
    }
    return found;
  }

  /// The same for frames drawn over targets with so many samples.
  std::size_t allocationsOver(View& view, VkSampleCountFlagBits samples) {
    const VkExtent2D extent{size, size};
    const Engine::Target color =
        engine().makeTarget(VK_FORMAT_R16G16B16A16_SFLOAT, extent, samples);
    const Engine::Target depth = engine().makeTarget(VK_FORMAT_D32_SFLOAT, extent, samples);
    engine().run([&](VkCommandBuffer commands) {
      Engine::clear(commands, color, {{0, 0, 0, 0}}, depth, 0);
    });
    const Composition over{.color = {color.image, color.view, color.format,
                                     VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL, samples},
                           .depth = {depth.image, depth.view, depth.format,
                                     VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL, samples}};
    return allocationsOf(view, {.over = &over}, {.aovs = {}});
  }

  CameraMatrices camera_ = {};
};

TEST_F(GivenAllocationTest, RecordedFramesAllocateNothing) {
  camera_ = orthographic(true, 24);
  for (const Method& method : methods) {
    SCOPED_TRACE(method.name);
    View view(renderer(), optionsOf(method));
    EXPECT_EQ(allocationsOver(view, VK_SAMPLE_COUNT_1_BIT), 0U);
    EXPECT_EQ(allocationsOver(view, VK_SAMPLE_COUNT_4_BIT), 0U);
    FrameOrder order{.aovs = {},
                     .onDevice = true,
                     .aovsOnDevice = {Aov::Exitance, Aov::Irradiance, Aov::Position, Aov::Normal,
                                      Aov::Depth, Aov::Evaluations, Aov::Object}};
    if (method.sum != Sum::Pattern) order.aovsOnDevice.push_back(Aov::Surfels);
    EXPECT_EQ(allocationsOf(view, {}, order), 0U);
  }
}

TEST_F(GivenAllocationTest, NorDoThoseThatReadAndWriteBuffersOfTheEngine) {
  camera_ = orthographic(true, 24);
  const std::vector<Vec3>& positions = scene_.objects[0].mesh.positionsMm;
  const std::size_t bytes = positions.size() * sizeof(Vec3);
  const Engine::HostBuffer moved = engine().makeBuffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  std::memcpy(moved.mapped, positions.data(), bytes);
  renderer().replacePositions(0, DevicePositions{.buffer = moved.buffer});
  const Engine::HostBuffer shaded =
      engine().makeBuffer(16 * positions.size(), VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  RenderOptions wanted = options();
  wanted.site = Site::Vertex;
  View view(renderer(), wanted);
  const DeviceExitance into{.object = 0, .buffer = shaded.buffer};
  EXPECT_EQ(allocationsOf(view, {.exitances = {&into, 1}}, {.aovs = {}, .exitance = true}), 0U);
}

}  // namespace
}  // namespace opaline::test
