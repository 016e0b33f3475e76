#include "renderer/frame/frame_queue.h"

#include <fmt/format.h>

#include <cstdint>

#include "gpu/device.h"
#include "opaline/error.h"
#include "renderer/scene/scene_resources.h"
#include "shaders/shared/frame.h"

namespace opaline {

namespace {

// Every pass of a frame: deform in two parts, normals, fit, shadow, map, neighbours, surfels, area
// lights, tree; of boundary transport the rays' boxes, clusters, their rays, rays and sources of
// every light, sources of every bounce, as many solutions and what further bounces add in two, sky,
// means and what is carried to vertices; estimate, scatter and nearby at the vertices and at the
// surfels; surface, scatter, nearby, carry, reflected sky, shade, reflected lights and shade again
// of every band of the largest picture, and as many at the pixels' centres; what is behind, and the
// surfels seen there; outputs for the caller.
constexpr std::uint32_t mostBands = 1024;  // 16384 × 16384 pixels with 8 samples each
constexpr std::uint32_t maxPassesOfFrame =
    10 + (3 + 2 * (shared::maxLights + 1) + 3 * (RenderOptions::maxBounces + 1) + 2 + 3) + 2 * 3 +
    2 * 8 * mostBands + 4;

}  // namespace

FrameSlot::FrameSlot(gpu::Device& device) : commands(device, "frame", maxPassesOfFrame) {}

FrameQueue::FrameQueue(gpu::Device& device) : slots_{FrameSlot(device), FrameSlot(device)} {}

bool FrameQueue::isEmpty() {
  while (waiting_ > 0 && !oldest().toHost) --waiting_;
  return waiting_ == 0;
}

void FrameQueue::requireRoom() {
  if (waiting_ == slots_.size() && !oldest().toHost) --waiting_;
  if (waiting_ < slots_.size()) return;
  throw UsageError(fmt::format(
      "{} frames of this view wait to be collected, and there may be no more; collect one first",
      waiting_));
}

void FrameQueue::submit(std::span<const gpu::SemaphoreValue> waits,
                        std::span<const gpu::SemaphoreValue> signals) {
  next().commands.submit(waits, signals);
  pass();
}

void FrameQueue::recordInto(VkCommandBuffer commands, const gpu::SemaphoreValue& done) {
  next().commands.recordInto(commands, done);
  pass();
}

void FrameQueue::pass() {
  next_ = (next_ + 1) % slots_.size();
  ++waiting_;
}

gpu::CommandCounts FrameQueue::collect(Frame& frame, FrameTimes& times) {
  if (waiting_ == 0) throw UsageError("no frame waits to be collected; submit one first");
  FrameSlot& slot = oldest();
  --waiting_;
  slot.commands.wait();
  slot.readback.finish(frame.images, frame.aovs);
  slot.readback.finishSolutions(frame.solutions);
  frame.provisional = slot.provisional;
  const std::vector<gpu::PassTiming>& timings = slot.commands.timings();
  frame.milliseconds = slot.commands.frameMilliseconds();
  frame.passes.resize(timings.size());
  for (std::size_t i = 0; i < timings.size(); ++i) {
    frame.passes[i].name = timings[i].name;
    frame.passes[i].milliseconds = timings[i].milliseconds;
  }
  times.add(frame.milliseconds, timings);
  return slot.commands.counts();
}

}  // namespace opaline
