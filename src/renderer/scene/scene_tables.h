#pragma once

#include "environment/spherical_harmonics.h"
#include "opaline/renderer.h"
#include "passes/products.h"
#include "renderer/scene/scene_resources.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// Puts what the shaders know of bodies, media and ambient light on the device. It depends on the
/// options' transport and roughness; for set-up, not for frames. `ambient` is radiance from all
/// around.
passes::SceneTables makeSceneTables(gpu::Device& device, const SceneResources& resources,
                                    const ShCoefficients& ambient, const RenderOptions& options);

}  // namespace opaline
