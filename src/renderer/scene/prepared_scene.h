#pragma once

#include <cstdint>
#include <optional>

#include "opaline/log.h"
#include "opaline/renderer.h"
#include "renderer/frame/frame_plan.h"
#include "renderer/frame/prepared_frames.h"
#include "renderer/scene/background_divider.h"
#include "renderer/scene/edited_scene.h"
#include "renderer/scene/scene_resources.h"

namespace opaline {

/// The scene on the device, as far as the frames so far needed it: decides what has to be made, and
/// what made anew because of an edit.
class PreparedScene {
 public:
  PreparedScene(gpu::Device& device, Passes& passes, LogCallback log);

  /// What the frame reads and writes, up to date. What one sum needs is kept for when it is asked
  /// for again.
  PreparedFrame& prepare(const RenderOptions& options, const FramePlan& plan, EditedScene& scene);
  /// Another scene will be set. The device is idle.
  void clear();

  /// Of the frame prepared last; none before the first, and after one that could not be.
  const PreparedFrame* frame() const { return frame_; }
  /// Of the scene, where there is a frame.
  SceneResources& scene() { return *resources_; }
  const SceneResources& scene() const { return *resources_; }
  /// Whether the surface is still divided for other media than the scene has now.
  bool isProvisional() const;

 private:
  SceneNeeds needsOf(const RenderOptions& options, const FramePlan& plan,
                     const Lighting& lighting) const;
  void make(const EditedScene& scene, const SceneNeeds& needs, Site site);
  void followMedia(EditedScene& scene, bool patient);
  void followLights(std::uint32_t lights);
  void orderDivision(const EditedScene& scene);
  void makeMap(const RenderOptions& options);
  void makeRoomForSeenSurfels();

  gpu::Device& device_;
  Passes& passes_;
  LogCallback log_;
  std::optional<SceneResources> resources_;
  std::uint64_t media_ = 0;  // count of changes that they have followed
  DivisionOrder wanted_;     // for these media
  BackgroundDivider divider_;
  PreparedFrames frames_;
  PreparedFrame* frame_ = nullptr;
};

}  // namespace opaline
