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

/// The number of variables that pixels' centres show, and the radiance.
constexpr std::size_t variablesOfCentres = static_cast<std::size_t>(Aov::Surfels) + 1;

/// What the passes of a frame read and write. It depends on scene and view, not on the frame.
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
  std::array<gpu::GpuImage, variablesOfCentres> variables;  ///< by Aov: left on the device
  std::optional<paper::Map> map;
  std::unique_ptr<MaterialMotion> materials;  ///< if a clip changes materials
};

/// Makes what depends on media, transport and roughness. `edited` is the scene that `scene` was
/// made of, and outlives the resources.
void makeTables(gpu::Device& device, const Passes& passes, SceneResources& scene,
                const RenderOptions& options, const Scene& edited, FrameResources& resources);

/// Makes the sky for these tables, which reads every pixel of the environment. `glossy`: also for
/// surfaces of any roughness.
void makeSky(gpu::Device& device, const Passes& passes, const Lighting& lighting,
             const RenderOptions& options, bool glossy, FrameResources& resources);

/// Makes what depends on the number of lights of each kind.
void makeShadows(gpu::Device& device, const Lighting& lighting, const RenderOptions& options,
                 bool cutOut, FrameResources& resources);

}  // namespace opaline
