#pragma once

#include "opaline/log.h"
#include "opaline/scene.h"
#include "passes/products.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// The opaque materials of a scene, `materials` of them, with their textures, and what they read of
/// its meshes. Notes go to `log`.
passes::OpaqueTables makeOpaqueTables(gpu::Device& device, const Scene& scene,
                                      const std::vector<OpaqueMaterial>& materials,
                                      const LogCallback& log);

}  // namespace opaline
