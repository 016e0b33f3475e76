#pragma once

#include "opaline/scene.h"
#include "scene/toml/reader.h"

namespace opaline::scene {

/// Adds the light of an entry of [[lights]].
void readLight(const TomlTable& table, const Vec3& centreMm, Lighting& lighting);

}  // namespace opaline::scene
