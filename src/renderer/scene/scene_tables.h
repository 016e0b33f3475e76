#pragma once

#include "opaline/renderer.h"
#include "passes/products.h"
#include "renderer/scene/scene_resources.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// Puts what the shaders know of bodies and media on the device. It depends on the options'
/// transport and roughness; for set-up, not for frames.
passes::SceneTables makeSceneTables(gpu::Device& device, const SceneResources& resources,
                                    const RenderOptions& options);

/// Lobes of that roughness by the cosine of the view, reflectionLobeEntries of them.
std::vector<shared::vec4> reflectionLobes(double roughness);

}  // namespace opaline
