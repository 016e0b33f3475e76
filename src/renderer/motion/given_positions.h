#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/command_list.h"
#include "opaline/types.h"
#include "opaline/view.h"
#include "opaline/vulkan.h"
#include "passes/deform/deform_pass.h"
#include "passes/products.h"
#include "renderer/motion/motion_tables.h"

namespace opaline {

/// Positions that the caller gives instead of a pose, from host memory or a buffer of the device.
/// Memory for them is allocated at the first use.
class GivenPositions {
 public:
  /// The scene has been moved to that origin; given positions have not. Its middle has been moved
  /// with it.
  GivenPositions(gpu::Device& device, std::vector<ObjectRange> ranges, const Vec3& originMm,
                 const Vec3& middleMm);

  /// Throw UsageError for an object that does not exist or positions that do not fit it.
  void give(std::size_t object, std::span<const Vec3> positionsMm, passes::Motion& motion);
  void give(std::size_t object, const DevicePositions& positions, passes::Motion& motion);
  void restore(std::size_t object);

  bool isGiven(std::size_t object) const { return objects_[object].source != Source::Pose; }
  /// Whether any are in a live buffer of the device, where they may change from frame to frame.
  bool readsDevice() const;

  /// Copies new positions to where the deform pass reads them.
  void record(gpu::CommandList& commands, const passes::DeformPass& pass, passes::Motion& motion);
  /// Copies the positions again with the next frame, unless the last recording was submitted.
  void abandon();

 private:
  static constexpr std::size_t slices = View::framesInFlight + 1;
  enum class Source { Pose, Host, Device };
  struct Given {
    Source source = Source::Pose;
    bool pending = false;  // Host: written, not yet copied
    bool copied = false;   // by what was recorded last
    gpu::Buffer buffer;    // Device: borrowed
    std::uint32_t offset = 0;
    std::uint32_t stride = 3;  // floats
    bool live = true;
  };

  Given& at(std::size_t object);
  std::size_t stagingOffset(std::size_t object) const;
  void makeRoom(passes::Motion& motion);

  gpu::Device& device_;
  std::vector<ObjectRange> ranges_;
  Vec3 origin_;
  Vec3 middle_;
  std::vector<Given> objects_;
  std::uint32_t vertices_ = 0;
  bool hasRoom_ = false;
  gpu::Buffer staging_;  // in slices: one is being written while frames in flight read others
  std::array<std::uint64_t, slices> submissions_{};  // the last that reads each slice
  std::size_t slice_ = 0;                            // the one that is being written
};

}  // namespace opaline
