#pragma once

#include <optional>

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
/// options' transport, pattern, map size and roughness; for set-up, not for frames. `pattern` is
/// there where the resources have an atlas.
passes::SceneTables makeSceneTables(gpu::Device& device, const SceneResources& resources,
                                    const std::optional<PatternLayout>& pattern,
                                    const Lighting& lighting, const RenderOptions& options);

}  // namespace opaline
