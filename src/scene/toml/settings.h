#pragma once

#include <optional>

#include "opaline/options/picture.h"
#include "opaline/scene_file.h"
#include "scene/toml/reader.h"

namespace opaline::scene {

/// Reads the [render] table of a scene. The log gets a note on keys that have been renamed.
SceneFileSettings readSettings(const TomlTable& root, const LogCallback& log);

/// Of the options that a [render] table says the first that is unused, in the words of such a file.
/// A default may stand in it wherever it is.
std::optional<options::Unused> unusedIn(options::Chosen<options::PictureSettings> said);

/// Throws Error where the settings name a clip that the scene does not have.
void requireClip(const TomlTable& root, const LoadedScene& loaded);

}  // namespace opaline::scene
