#pragma once

#include "scene/gltf/decoded.h"

namespace opaline::scene {

inline constexpr const char* dracoExtension = "KHR_draco_mesh_compression";

/// KHR_draco_mesh_compression: decodes every compressed primitive and gives it accessors of its
/// own, as if it had never been compressed. Throws Error for streams that are damaged or do not fit
/// their primitive.
void decodeDraco(GltfDecoded& decoded);

}  // namespace opaline::scene
