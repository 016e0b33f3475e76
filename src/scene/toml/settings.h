#pragma once

#include "opaline/scene_file.h"
#include "scene/toml/reader.h"

namespace opaline::scene {

/// Reads the [render] table of a scene. The log gets a note on keys that have been renamed.
SceneFileSettings readSettings(const TomlTable& root, const LogCallback& log);

/// Throws Error where the settings name a clip that the scene does not have.
void requireClip(const TomlTable& root, const LoadedScene& loaded);

}  // namespace opaline::scene
