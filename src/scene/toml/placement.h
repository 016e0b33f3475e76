#pragma once

#include <optional>

#include "opaline/scene_file.h"
#include "scene/raw_scene.h"
#include "scene/toml/reader.h"

namespace opaline::scene {

/// The placement that an object's table describes; none where it describes none.
std::optional<Placement> readPlacement(const TomlTable& table);

/// Throws Error, naming `table`, for a placement that flattens the object or leaves the range of a
/// float.
void place(RawObject& object, const Placement& placement, const TomlTable& table);
/// The same for a whole model with its lights and camera. Intensities grow with its surface, so
/// that the picture stays the same.
void place(RawScene& model, const Placement& placement, const TomlTable& table);

}  // namespace opaline::scene
