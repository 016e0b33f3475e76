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

/// The scene on the device, divided in one way, as far as frames have needed it so far. It decides
/// what has to be made, and what an edit requires to be remade.
class PreparedScene {
 public:
  PreparedScene(gpu::Device& device, Passes& passes, LogCallback log);

  /// Whether it suits the frame: it may lack something, but has nothing that the frame needs to be
  /// different.
  bool fits(const RenderOptions& options, const FramePlan& plan, const EditedScene& scene) const;
  /// Updates what the frame needs. What other sums need is kept for later frames. `patient`: waits
  /// until the surface is divided for the scene's media.
  void prepare(const RenderOptions& options, const FramePlan& plan, bool patient,
               EditedScene& scene);
  /// Drops everything, because another scene will be set.
  void clear();

  /// The scene's changes, combined with those of what was remade here.
  SceneChanges changes(const EditedScene& scene) const;
  /// Knows whose light the surfels hold.
  LightReuse& light() { return light_; }
  /// Knows which frame's shape the resources hold.
  ShapeReuse& shape() { return shape_; }

  /// The resources; only after the first prepare().
  SceneResources& scene() { return *resources_; }
  const SceneResources& scene() const { return *resources_; }
  /// Whether the surface is still divided for earlier media of the scene.
  bool isProvisional() const;

 private:
  SceneNeeds needsOf(const RenderOptions& options, const FramePlan& plan,
                     const EditedScene& scene) const;
  void make(EditedScene& scene, const SceneNeeds& needs, Site site);
  void followMedia(EditedScene& scene, bool patient);
  void followLights(std::uint32_t lights);
  bool hasOtherSolids(const EditedScene& scene) const;
  void orderDivision(const EditedScene& scene);
  void layFlat(int mapSize);

  gpu::Device& device_;
  Passes& passes_;
  LogCallback log_;
  std::optional<SceneResources> resources_;
  std::uint64_t made_ = 0;   // EditedScene::noteMaking() of the last making
  std::uint64_t media_ = 0;  // SceneChanges::media that the resources have followed
  DivisionOrder wanted_;     // for the current media
  BackgroundDivider divider_;
  LightReuse light_;
  ShapeReuse shape_;
};

}  // namespace opaline
