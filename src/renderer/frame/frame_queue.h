#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "gpu/command_list.h"
#include "opaline/view.h"
#include "renderer/frame/readback.h"
#include "renderer/frame/timing.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// One of the frames in flight.
struct FrameSlot {
  explicit FrameSlot(gpu::Device& device);

  gpu::CommandList commands;
  Readback readback;
  bool provisional = false;  ///< see Frame
  bool toHost = true;        ///< brings pictures to the host, which have to be collected
};

/// The frames of a view that were submitted but not collected.
class FrameQueue {
 public:
  explicit FrameQueue(gpu::Device& device);

  /// Whether no frame with pictures for the host waits to be collected. Forgets frames without.
  bool isEmpty();
  /// Makes room for a frame: forgets the oldest if it brings nothing to the host. Throws UsageError
  /// when there is none.
  void requireRoom();
  /// The slot of the next frame, to be recorded.
  FrameSlot& next() { return slots_[next_]; }
  /// Hands next() to the device.
  void submit(std::span<const gpu::SemaphoreValue> waits = {},
              std::span<const gpu::SemaphoreValue> signals = {});
  /// Records next() for others to submit.
  void recordInto(VkCommandBuffer commands, const gpu::SemaphoreValue& done);
  /// After an exception before submission: next() has to be recorded again.
  void abandon() { next().commands.abandon(); }
  /// Waits for the oldest frame and takes its pictures and times. Throws UsageError when there is
  /// none.
  gpu::CommandCounts collect(Frame& frame, FrameTimes& times);

 private:
  FrameSlot& oldest() { return slots_[(next_ + slots_.size() - waiting_) % slots_.size()]; }
  void pass();

  std::array<FrameSlot, View::framesInFlight> slots_;
  std::size_t next_ = 0;  // slot of the next frame
  std::size_t waiting_ = 0;
};

}  // namespace opaline
