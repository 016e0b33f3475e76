#pragma once

#include <optional>
#include <vector>

#include "opaline/log.h"
#include "opaline/scene.h"
#include "passes/products.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// Whether paint is seen of it.
bool isPainted(const Object& object);

/// What textures an object's surface has: those of its opaque material, or its paint as base
/// colour.
std::optional<OpaqueMaterial> surfaceMaterialOf(const Object& object);

/// The materials of a scene, `materials` of them, with their textures, and what they read of its
/// meshes. Notes go to `log`.
passes::OpaqueTables makeOpaqueTables(gpu::Device& device, const Scene& scene,
                                      const std::vector<OpaqueMaterial>& materials,
                                      const LogCallback& log);

}  // namespace opaline
