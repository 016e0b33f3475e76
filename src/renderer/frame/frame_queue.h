#pragma once

#include <array>
#include <cstddef>

#include "gpu/command_list.h"
#include "opaline/view.h"
#include "renderer/frame/readback.h"
#include "renderer/frame/timing.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// One of the frames that may be under way.
struct FrameSlot {
  explicit FrameSlot(gpu::Device& device);

  gpu::CommandList commands;
  Readback readback;
  bool provisional = false;  ///< see Frame
};

/// The frames of a view that were submitted and not collected.
class FrameQueue {
 public:
  explicit FrameQueue(gpu::Device& device);

  bool isEmpty() const { return waiting_ == 0; }
  /// Throws UsageError when as many are under way as there may be.
  void requireRoom() const;
  /// To be recorded.
  FrameSlot& next() { return slots_[next_]; }
  /// Hands next() to the device.
  void submit();
  /// After an exception before that: next() is to be recorded anew.
  void abandon() { next().commands.abandon(); }
  /// Waits for the oldest and takes its pictures and times. Throws UsageError when there is none.
  gpu::CommandCounts collect(Frame& frame, FrameTimes& times);

 private:
  std::array<FrameSlot, View::framesInFlight> slots_;
  std::size_t next_ = 0;  // slot of the next frame
  std::size_t waiting_ = 0;
};

}  // namespace opaline
