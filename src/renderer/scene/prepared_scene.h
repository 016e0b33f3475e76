#pragma once

#include <cstdint>
#include <optional>

#include "opaline/log.h"
#include "opaline/render_options.h"
#include "renderer/frame/frame_plan.h"
#include "renderer/frame/light_reuse.h"
#include "renderer/frame/shape_reuse.h"
#include "renderer/scene/background_divider.h"
#include "renderer/scene/edited_scene.h"
#include "renderer/scene/scene_resources.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

struct Passes;

/// The scene on the device, divided in one way, as far as the frames so far needed it: decides what
/// has to be made, and what made anew because of an edit.
class PreparedScene {
 public:
  PreparedScene(gpu::Device& device, Passes& passes, LogCallback log);

  /// Whether it has nothing else that the frame needs otherwise, but lacks it at most.
  bool fits(const RenderOptions& options, const FramePlan& plan, const Lighting& lighting) const;
  /// Brings what the frame needs up to date. What one sum needs is kept for when it is asked for
  /// again. `patient`: waits until the surface is divided for the scene's media.
  void prepare(const RenderOptions& options, const FramePlan& plan, bool patient,
               EditedScene& scene);
  /// Another scene will be set.
  void clear();

  /// Those of the scene, and what was made anew here.
  SceneChanges changes(const EditedScene& scene) const;
  /// Whose light the surfels hold.
  LightReuse& light() { return light_; }
  /// Whose shape.
  ShapeReuse& shape() { return shape_; }

  /// After the first frame.
  SceneResources& scene() { return *resources_; }
  const SceneResources& scene() const { return *resources_; }
  /// Whether the surface is still divided for other media than the scene has now.
  bool isProvisional() const;

 private:
  SceneNeeds needsOf(const RenderOptions& options, const FramePlan& plan,
                     const Lighting& lighting) const;
  void make(EditedScene& scene, const SceneNeeds& needs, Site site);
  void followMedia(EditedScene& scene, bool patient);
  void followLights(std::uint32_t lights);
  void orderDivision(const EditedScene& scene);
  void layFlat(int mapSize);

  gpu::Device& device_;
  Passes& passes_;
  LogCallback log_;
  std::optional<SceneResources> resources_;
  std::uint64_t made_ = 0;   // number of the last making, of all scenes
  std::uint64_t media_ = 0;  // count of changes that they have followed
  DivisionOrder wanted_;     // for these media
  BackgroundDivider divider_;
  LightReuse light_;
  ShapeReuse shape_;
};

}  // namespace opaline
