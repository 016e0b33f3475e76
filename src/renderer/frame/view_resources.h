#pragma once

#include <array>
#include <optional>

#include "opaline/render_options.h"
#include "opaline/scene.h"
#include "renderer/frame/camera_view.h"
#include "renderer/frame/frame_plan.h"
#include "renderer/frame/frame_resources.h"
#include "renderer/scene/edited_scene.h"
#include "renderer/scene/scene_changes.h"
#include "renderer/scene/scene_resources.h"
#include "shaders/shared/frame.h"

namespace opaline {

/// What a view has on the device. It follows options and scene, and remakes only what a change
/// concerns. The picture is kept until its size changes, because the caller may show it while the
/// rest is remade.
class ViewResources {
 public:
  ViewResources(gpu::Device& device, const Passes& passes);

  /// Brings all that the frame needs up to date.
  void follow(const RenderOptions& options, const FramePlan& plan, SceneResources& scene,
              const EditedScene& edited, const SceneChanges& changes);

  /// After a failed frame: keeps only the picture, without its contents.
  void forget();

  FrameResources& made() { return made_; }
  const FrameResources& made() const { return made_; }

  /// The frame whose light the resources hold; none if something that holds light was remade.
  struct Lit {
    RenderOptions options;
    SceneChanges changes;
    Site site = Site::Vertex;
    bool map = false;
    bool rays = false;   ///< the surface is ready for rays
    bool means = false;  ///< clusters have means of half-spaces
  };
  std::optional<Lit> lit;

  /// The frame whose shadow maps the resources hold; none if the maps were remade.
  struct Shadows {
    SceneChanges changes;  ///< SceneChanges::withoutLight()
    std::array<shared::LightData, shared::maxLights> lights;
  };
  std::optional<Shadows> shadows;

  /// The picture whose visible surfaces the resources hold; none if their memory was remade or
  /// overwritten.
  struct Sight {
    SceneChanges changes;  ///< SceneChanges::withoutLight()
    CameraView camera;
    int antialias = 0;
    float roughness = 0;
    bool mirrorsSky = false;
    bool backdrop = false;

    bool operator==(const Sight&) const = default;
  };
  std::optional<Sight> sight;

 private:
  /// What the resources were made for.
  struct For {
    RenderOptions options;
    SceneChanges changes;
  };
  void dropAllButPicture();
  void makeBackdrop(const FramePlan& plan, const EditedScene& edited, bool anew);
  void makeExitance(const SceneResources& scene);
  void makeImages(const RenderOptions& options);
  void makeRoom(const FramePlan& plan, const Lighting& lighting, bool cutOut);
  void makeMap(const RenderOptions& options, SceneResources& scene);

  gpu::Device& device_;
  const Passes& passes_;
  FrameResources made_;
  std::optional<For> for_;  // none before the first frame and after a failed one
};

}  // namespace opaline
