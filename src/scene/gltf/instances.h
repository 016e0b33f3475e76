#pragma once

#include "scene/gltf/file.h"

namespace opaline::scene {

/// EXT_mesh_gpu_instancing: gives every node that is drawn many times a child for each instance,
/// which has the mesh instead of it. Throws Error for attributes that do not fit together.
void expandInstances(const Input& input, tinygltf::Model& model);

}  // namespace opaline::scene
