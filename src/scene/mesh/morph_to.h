#pragma once

#include <filesystem>

#include "opaline/log.h"
#include "scene/raw_scene.h"

namespace opaline::scene {

/// Makes the only object of a scene, as its file gives it, morph to the positions of another file
/// and back: one target without normals, a clip "morph" of 4 s. Throws Error, naming both files,
/// where their topologies differ.
void addMorph(RawScene& scene, const std::filesystem::path& file,
              const std::filesystem::path& other, const LogCallback& log);

}  // namespace opaline::scene
