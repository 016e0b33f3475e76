#pragma once

#include <set>
#include <vector>

#include "scene/gltf/file.h"
#include "scene/gltf/nodes.h"
#include "scene/not_shown.h"

namespace opaline::scene {

/// What no picture shows of the drawn nodes, their materials and the file's extensions.
std::vector<NotShown> notShownOf(const tinygltf::Model& model, const GltfNodes& nodes,
                                 const std::set<int>& opaque);

}  // namespace opaline::scene
