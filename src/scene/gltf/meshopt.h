#pragma once

#include <array>

#include "scene/gltf/decoded.h"

namespace opaline::scene {

inline constexpr std::array<const char*, 2> meshoptExtensions{"EXT_meshopt_compression",
                                                              "KHR_meshopt_compression"};

/// EXT_meshopt_compression and its successor KHR_meshopt_compression: decodes every compressed
/// buffer view and leaves it as if it had never been compressed. Throws Error for streams that are
/// damaged or do not fit their view.
void decodeMeshopt(GltfDecoded& decoded);

}  // namespace opaline::scene
