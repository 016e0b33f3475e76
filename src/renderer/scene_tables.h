#pragma once

#include <vector>

#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "passes/products.h"
#include "renderer/pattern_layout.h"
#include "renderer/scene_resources.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// Puts what the shaders know of bodies, media and ambient light on the device. It depends on the
/// options' transport, pattern, map size and roughness; for set-up, not for frames.
passes::SceneTables makeSceneTables(gpu::Device& device, const SceneResources& resources,
                                    const PatternLayout& pattern,
                                    const std::vector<std::uint32_t>& firstSourceOfObject,
                                    const Lighting& lighting, const RenderOptions& options);

}  // namespace opaline
