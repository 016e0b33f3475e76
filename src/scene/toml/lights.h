#pragma once

#include "opaline/scene.h"
#include "scene/toml/reader.h"

namespace opaline::scene {

/// Adds what an entry of [[lights]] says.
void readLight(const TomlTable& table, const Vec3& centreMm, Lighting& lighting);

}  // namespace opaline::scene
