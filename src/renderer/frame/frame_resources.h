#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "gpu/image.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "paper/technique.h"
#include "passes/products.h"
#include "renderer/motion/material_motion.h"
#include "renderer/scene/scene_resources.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

struct Passes;

/// Those that are seen at the pixels' centres, and the radiance.
constexpr std::size_t variablesOfCentres = static_cast<std::size_t>(Aov::Surfels) + 1;

/// What the passes of a frame read and write; depends on scene and view, not on the frame.
struct FrameResources {
  passes::SceneTables tables;
  passes::FrameView view;
  passes::ShadowMaps shadows;
  passes::VisibleSurfaces surfaces;
  passes::Exitance exitance;
  passes::Sky sky;
  passes::Backdrop backdrop;    ///< empty unless the last frame showed it
  gpu::GpuImage radiance;       ///< the picture
  passes::SeenCentres centres;  ///< these four are empty until a plan asks for them
  passes::SeenSurfels seenSurfels;
  gpu::GpuImage seenIrradiance;
  std::array<gpu::GpuImage, variablesOfCentres> variables;  ///< by Aov: left for others
  std::optional<paper::Map> map;
  std::unique_ptr<MaterialMotion> materials;  ///< where a clip changes what objects are made of
};

/// What depends on media, transport and roughness. `edited` is the scene that `scene` was made of,
/// and outlives the resources.
void makeTables(gpu::Device& device, const Passes& passes, SceneResources& scene,
                const RenderOptions& options, const Scene& edited, FrameResources& resources);

/// Makes the sky of these tables, which looks at every pixel of the environment. `glossy`: for
/// surfaces of any roughness too.
void makeSky(gpu::Device& device, const Passes& passes, const Lighting& lighting,
             const RenderOptions& options, bool glossy, FrameResources& resources);

/// What depends on how many lights there are of which kind.
void makeShadows(gpu::Device& device, const Lighting& lighting, const RenderOptions& options,
                 bool cutOut, FrameResources& resources);

}  // namespace opaline
