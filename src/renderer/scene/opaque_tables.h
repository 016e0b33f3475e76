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

/// Whether paint is seen of it.
bool isPainted(const Object& object);

/// Whether it is translucent and has a roughness or normals of its own; or normals.
bool hasOwnSurface(const Object& object);
bool hasOwnNormals(const Object& object);

/// What textures an object's surface has: those of its opaque material, or its paint as base
/// colour and those of its own surface.
std::optional<OpaqueMaterial> surfaceMaterialOf(const Object& object);

/// Sets the numbers of a material that clips may change. Allocates nothing.
void setNumbers(const OpaqueMaterial& material, shared::OpaqueData& data);

/// The materials of a scene, `materials` of them, with their textures, and what they read of its
/// meshes. Notes go to `log`, what the table of materials was made of to `onHost`. Leaves in
/// `packer` where the textures lie.
passes::OpaqueTables makeOpaqueTables(gpu::Device& device, const Scene& scene,
                                      const std::vector<OpaqueMaterial>& materials,
                                      std::optional<TexturePacker>& packer, const LogCallback& log,
                                      std::vector<shared::OpaqueData>& onHost);

/// Others of the same number or not, as long as `packer` knows all their textures: else false, and
/// nothing is done.
bool retakeMaterials(gpu::Device& device, const Scene& scene,
                     const std::vector<OpaqueMaterial>& materials,
                     std::optional<TexturePacker>& packer, passes::OpaqueTables& tables,
                     std::vector<shared::OpaqueData>& onHost);

}  // namespace opaline
