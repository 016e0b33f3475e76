#pragma once

#include "scene/gltf/file.h"

namespace opaline::scene {

/// EXT_mesh_gpu_instancing: gives every instanced node one child per instance. The children take
/// over the node's mesh. Throws Error for attributes that do not fit together.
void expandInstances(const Input& input, tinygltf::Model& model);

}  // namespace opaline::scene
