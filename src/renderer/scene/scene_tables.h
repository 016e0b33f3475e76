#pragma once

#include <optional>

#include "opaline/renderer.h"
#include "passes/products.h"
#include "renderer/scene/pattern_layout.h"
#include "renderer/scene/scene_resources.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// Puts what the shaders know of bodies and media on the device. It depends on the
/// options' transport, pattern, map size and roughness; for set-up, not for frames. `pattern` is
/// there where the resources have an atlas.
passes::SceneTables makeSceneTables(gpu::Device& device, const SceneResources& resources,
                                    const std::optional<PatternLayout>& pattern,
                                    const RenderOptions& options);

}  // namespace opaline
