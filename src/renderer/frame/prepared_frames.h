#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "renderer/frame/frame_resources.h"
#include "renderer/scene/scene_changes.h"
#include "renderer/scene/scene_resources.h"

namespace opaline {

/// Resources for one kind of frame: of one size and method.
struct PreparedFrame {
  RenderOptions options;  ///< they were made for
  SceneChanges changes;   ///< up to which they were made
  bool whole = false;     ///< else of the resources there is only the picture
  FrameResources resources;
  /// The frame whose light they hold.
  struct Lit {
    RenderOptions options;
    SceneChanges changes;
    Site site = Site::Vertex;
    bool map = false;
    bool rays = false;  ///< the surface is ready for them
  };
  std::optional<Lit> lit;
};

/// Keeps the resources of two kinds of frame, so that two pictures may take turns, and makes again
/// only what a change concerns. A picture stays until a frame of a third kind takes its place:
/// others may show it while what was made for it is made anew.
class PreparedFrames {
 public:
  PreparedFrames(gpu::Device& device, const Passes& passes);

  /// Waits for the device where anything has to be made.
  PreparedFrame& of(const RenderOptions& options, SceneResources& scene, const Lighting& lighting,
                    const SceneChanges& changes);
  /// Drops what the paper's method has of them. The device is idle.
  void dropMaps();
  /// Drops all but the pictures. The device is idle.
  void clear();

 private:
  struct Slot {
    std::optional<PreparedFrame> frame;
    std::uint64_t lastUse = 0;
  };
  void make(PreparedFrame& frame, SceneResources& scene, const Lighting& lighting);
  void renew(PreparedFrame& frame, SceneResources& scene, const Lighting& lighting,
             const SceneChanges& changes);

  gpu::Device& device_;
  const Passes& passes_;
  std::array<Slot, 2> slots_;
  std::uint64_t uses_ = 0;
};

}  // namespace opaline
