#pragma once

#include <optional>
#include <vector>

#include "opaline/log.h"
#include "opaline/scene.h"
#include "passes/products.h"
#include "renderer/scene/texture_packer.h"
#include "shaders/shared/opaque.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// Whether an object shows paint.
bool isPainted(const Object& object);

/// Whether an object is translucent and has a roughness or normals of its own; the second only for
/// normals.
bool hasOwnSurface(const Object& object);
bool hasOwnNormals(const Object& object);

/// The textures of an object's surface as a material: its opaque material, or its paint as base
/// colour and those of its own surface.
std::optional<OpaqueMaterial> surfaceMaterialOf(const Object& object);

/// Sets the numbers of a material that clips may change. Allocates nothing.
void setNumbers(const OpaqueMaterial& material, shared::OpaqueData& data);

/// The materials of a scene, `materials` of them, with their textures, and what they read of its
/// meshes. Notes go to `log`, and the contents of the table of materials to `onHost`. `packer` then
/// knows where the textures lie.
passes::OpaqueTables makeOpaqueTables(gpu::Device& device, const Scene& scene,
                                      const std::vector<OpaqueMaterial>& materials,
                                      std::optional<TexturePacker>& packer, const LogCallback& log,
                                      std::vector<shared::OpaqueData>& onHost);

/// Replaces the materials, whose number may differ. If `packer` does not know all their textures,
/// does nothing and returns false.
bool retakeMaterials(gpu::Device& device, const Scene& scene,
                     const std::vector<OpaqueMaterial>& materials,
                     std::optional<TexturePacker>& packer, passes::OpaqueTables& tables,
                     std::vector<shared::OpaqueData>& onHost);

}  // namespace opaline
