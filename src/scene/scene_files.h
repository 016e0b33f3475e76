#pragma once

#include <filesystem>
#include <vector>

#include "scene/scene_source.h"

namespace opaline::scene {

/// Every file that a scene was made of, and those that its model names, textures among them,
/// whether or not they are read: what must not be written over. Of numbered meshes none.
std::vector<std::filesystem::path> filesOf(const SceneSource& source);

}  // namespace opaline::scene
