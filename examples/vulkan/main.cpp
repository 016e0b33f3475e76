// An engine with its own Vulkan device draws a floor. The library draws a waving body of wax over
// it, in the engine's command buffers. A compute shader of the engine moves the body's vertices.
// One thread simulates, another renders; both use one queue.
//
//     engine [frames [picture.png [--validate]]]
#include <opaline/opaline.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <thread>
#include <vector>

#include "camera.h"
#include "engine.h"

namespace {

constexpr VkExtent2D extent{480, 320};
constexpr int inFlight = 2;  // frames, and buffers of positions

opaline::Scene makeScene() {
  opaline::LoadOptions load;
  load.diagonalMm = 40;
  load.medium = opaline::findMedium("wax");
  opaline::Scene scene = opaline::builtInBear(load);
  scene.lighting = {};
  scene.lighting.directional.push_back({{0.5F, 0.6F, -0.6245F}, {4, 4, 4}});
  scene.lighting.ambient = {0.15F, 0.15F, 0.18F};
  return scene;
}

/// How many frames each thread has submitted. Work that waits on the queue must not be submitted
/// before the work for which it waits.
struct Progress {
  std::atomic<int> simulated = 0;
  std::atomic<int> rendered = 0;

  std::atomic<bool> stopped = false;

  /// Whether the other thread got that far; it may have stopped before.
  bool await(std::atomic<int>& count, int least) const {
    for (int now = count; now < least && !stopped; now = count) count.wait(now);
    return !stopped;
  }
  static void pass(std::atomic<int>& count) {
    ++count;
    count.notify_all();
  }
  void stop() {
    stopped = true;
    for (std::atomic<int>* count : {&simulated, &rendered}) pass(*count);
  }
};

opaline::TimelinePoint after(VkSemaphore timeline, int frames) {
  return {timeline, static_cast<std::uint64_t>(std::max(frames, 0))};
}

float fromHalf(std::uint16_t half) {
  const int exponent = half >> 10 & 31;
  const float fraction = static_cast<float>(half & 1023) / 1024;
  const float size =
      exponent == 0 ? std::ldexp(fraction, -14) : std::ldexp(1 + fraction, exponent - 15);
  return (half & 0x8000) != 0 ? -size : size;
}

opaline::Image pictureOf(const void* halves) {
  opaline::Image picture(static_cast<int>(extent.width), static_cast<int>(extent.height));
  std::vector<std::uint16_t> texels(picture.rgba.size());
  std::memcpy(texels.data(), halves, 2 * texels.size());
  std::transform(texels.begin(), texels.end(), picture.rgba.begin(), fromHalf);
  return picture;
}

void run(int frames, const char* file, Engine& engine) {
  const opaline::Scene scene = makeScene();
  const std::vector<opaline::Vec3>& rest = scene.objects[0].mesh.positionsMm;
  const std::size_t bytes = sizeof(opaline::Vec3) * rest.size();
  const auto vertices = static_cast<std::uint32_t>(rest.size());
  const opaline::Vec3 middle = opaline::middleOf(opaline::boundsOf(scene));
  const float lowest = opaline::boundsOf(scene).minMm[1];
  constexpr float aspect = static_cast<float>(extent.width) / static_cast<float>(extent.height);

  // The engine's own buffers.
  constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  const Engine::Buffer atRest = engine.makeBuffer(bytes, storage);
  std::memcpy(atRest.mapped, rest.data(), bytes);
  const Engine::Buffer positions[inFlight] = {engine.makeBuffer(bytes, storage),
                                              engine.makeBuffer(bytes, storage)};
  const Engine::Image color =
      engine.makeImage(VK_FORMAT_R16G16B16A16_SFLOAT, extent,
                       VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                       VK_IMAGE_ASPECT_COLOR_BIT);
  const Engine::Image depth =
      engine.makeImage(VK_FORMAT_D32_SFLOAT, extent, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                       VK_IMAGE_ASPECT_DEPTH_BIT);
  const Engine::Buffer picture =
      engine.makeBuffer(8 * extent.width * extent.height, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  const VkSemaphore simulation = engine.makeTimeline();
  const VkSemaphore rendering = engine.makeTimeline();
  const Engine::Commands ofSimulating[inFlight] = {engine.makeCommands(), engine.makeCommands()};
  const Engine::Commands ofDrawing[inFlight] = {engine.makeCommands(), engine.makeCommands()};

  // Thread one moves the vertices. A buffer is written again once the frame that read it is
  // finished.
  Progress progress;
  std::exception_ptr ofSimulation;
  std::exception_ptr ofRendering;
  std::thread simulate([&] {
    try {
      for (int frame = 0; frame < frames; ++frame) {
        if (!progress.await(progress.rendered, frame - inFlight + 1)) return;
        engine.waitFor(after(simulation, frame - inFlight + 1));
        const VkCommandBuffer commands = engine.begin(ofSimulating[frame % inFlight]);
        engine.wave(commands, atRest.buffer, positions[frame % inFlight].buffer, vertices,
                    static_cast<float>(frame) / 60);
        engine.submit(commands, after(rendering, frame - inFlight + 1),
                      after(simulation, frame + 1));
        Progress::pass(progress.simulated);
      }
    } catch (...) {
      ofSimulation = std::current_exception();
      progress.stop();
    }
  });

  // Thread two renders the picture.
  try {
    opaline::Renderer renderer({.given = engine.given()});
    renderer.setScene(scene);
    opaline::RenderOptions options;
    options.width = static_cast<int>(extent.width);
    options.height = static_cast<int>(extent.height);
    opaline::View view(renderer, options);
    const opaline::FrameOrder nothingToTheHost{.aovs = {}};
    view.prepare(nothingToTheHost);  // from here on the library submits nothing
    const opaline::Composition over{
        .color = {color.image, color.view, color.format},
        .depth = {depth.image, depth.view, depth.format},
    };
    for (int frame = 0; frame < frames; ++frame) {
      const Camera camera =
          lookAt({middle[0] + 30 * std::sin(0.02F * frame), middle[1] + 20, middle[2] + 75}, middle,
                 3, aspect, 1);
      view.setCamera(camera.matrices);
      renderer.replacePositions(
          0, opaline::DevicePositions{.buffer = positions[frame % inFlight].buffer});

      if (!progress.await(progress.simulated, frame + 1)) break;
      engine.waitFor(after(rendering, frame - inFlight + 1));
      const VkCommandBuffer commands = engine.begin(ofDrawing[frame % inFlight]);
      engine.drawFloor(commands, color, depth, extent, camera, lowest);
      view.record({.commands = commands,
                   .finished = after(rendering, frame + 1),
                   .outputs = {.over = &over}},
                  nothingToTheHost);
      if (frame + 1 == frames) engine.copy(commands, color, extent, picture.buffer);
      engine.submit(commands, after(simulation, frame + 1), after(rendering, frame + 1));
      Progress::pass(progress.rendered);
    }
    if (!progress.stopped) engine.waitFor(after(rendering, frames));
    std::printf("%d frames, %.1f MB of the device's memory\n", frames,
                static_cast<double>(renderer.memoryBytes()) / 1e6);
  } catch (...) {
    ofRendering = std::current_exception();
    progress.stop();
  }
  simulate.join();
  for (const std::exception_ptr& failure : {ofSimulation, ofRendering})
    if (failure) std::rethrow_exception(failure);
  if (frames > 0) opaline::writePng({file}, opaline::toneMap(pictureOf(picture.mapped), {}));
}

}  // namespace

int main(int count, char** words) try {
  const int frames = count > 1 ? std::atoi(words[1]) : 60;
  const char* file = count > 2 ? words[2] : "engine.png";
  Engine engine(count > 3 && std::strcmp(words[3], "--validate") == 0);
  run(frames, file, engine);
  return engine.complaints() == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
