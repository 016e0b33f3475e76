#pragma once

#include "scene/raw_scene.h"
#include "scene/toml/reader.h"

namespace opaline::scene {

/// What [camera] says, instead of the scene's own camera and its motion; nothing changes where
/// there is no such table.
void readCamera(const TomlTable& root, const Vec3& centreMm, const LogCallback& log,
                RawScene& scene);

}  // namespace opaline::scene
