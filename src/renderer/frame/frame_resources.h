#pragma once

#include <optional>

#include "gpu/image.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "paper/technique.h"
#include "passes/products.h"
#include "renderer/frame/frame_plan.h"
#include "renderer/scene/scene_resources.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

struct Passes;

/// What the passes of a frame read and write; depends on scene and options, not on the frame.
struct FrameResources {
  passes::SceneTables tables;
  passes::FrameView view;
  passes::ShadowMaps shadows;
  passes::VisibleSurfaces surfaces;
  passes::SeenCentres centres;
  passes::Exitance exitance;
  passes::Sky sky;
  gpu::GpuImage radiance;           ///< the picture
  passes::SeenSurfels seenSurfels;  ///< these are empty until a plan asks for them
  gpu::GpuImage seenIrradiance;
  std::optional<paper::Map> map;
};

/// Makes everything for these options but what makeRoom adds; of the picture, what is there stays.
void makeFrameResources(gpu::Device& device, const Passes& passes, SceneResources& scene,
                        const Lighting& lighting, const RenderOptions& options,
                        FrameResources& resources);

/// Makes, of what a pixel needs in a frame of this plan, what is not there yet. Waits for the
/// device where anything has to be made.
void makeRoom(gpu::Device& device, const FramePlan& plan, FrameResources& resources);

/// Drops everything but the picture.
void keepOnlyPicture(FrameResources& resources);

/// Makes the sky again, which looks at every pixel of the environment.
void remakeSky(gpu::Device& device, const Passes& passes, const Lighting& lighting,
               const RenderOptions& options, FrameResources& resources);

/// Makes again what depends on media.
void remakeTables(gpu::Device& device, const SceneResources& scene, const RenderOptions& options,
                  FrameResources& resources);

/// Makes again what depends on how many lights there are of which kind.
void remakeShadows(gpu::Device& device, const Lighting& lighting, const RenderOptions& options,
                   FrameResources& resources);

}  // namespace opaline
