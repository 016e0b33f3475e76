#pragma once

#include "scene/raw_scene.h"
#include "scene/toml/reader.h"

namespace opaline::scene {

/// Applies [camera], which replaces the scene's own camera and its motion. Without such a table
/// nothing changes.
void readCamera(const TomlTable& root, const Vec3& centreMm, RawScene& scene);

}  // namespace opaline::scene
