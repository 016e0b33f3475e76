#pragma once

#include "scene/scene_settings.h"
#include "scene/toml/reader.h"

namespace opaline::scene {

/// The [render] table of a scene.
SceneFileSettings readSettings(const TomlTable& root);

/// Throws Error where the settings name a clip that the scene does not have.
void requireClip(const TomlTable& root, const LoadedScene& loaded);

}  // namespace opaline::scene
