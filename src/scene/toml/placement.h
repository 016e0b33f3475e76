#pragma once

#include <optional>

#include "opaline/scene_file.h"
#include "scene/raw_scene.h"
#include "scene/toml/reader.h"

namespace opaline::scene {

/// What an object's table says of its place; nothing where it says nothing.
std::optional<Placement> readPlacement(const TomlTable& table);

/// Throws Error, naming `table`, for a placement that flattens or leaves the range of a float.
void place(RawObject& object, const Placement& placement, const TomlTable& table);
/// The same of a whole model with its lights and its camera. Intensities grow with its surface, so
/// that the picture stays.
void place(RawScene& model, const Placement& placement, const TomlTable& table);

}  // namespace opaline::scene
