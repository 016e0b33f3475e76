#pragma once

#include <optional>
#include <string_view>

#include "opaline/scene.h"
#include "scene/toml/reader.h"

namespace opaline::scene {

/// A place that is given from the centre. In double precision every place can be given.
std::optional<Vec3> placeFrom(const TomlTable& table, std::string_view key, const Vec3& centreMm);

/// Adds what an entry of [[lights]] says.
void readLight(const TomlTable& table, const Vec3& centreMm, Lighting& lighting);

}  // namespace opaline::scene
