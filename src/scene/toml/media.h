#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "opaline/medium.h"
#include "scene/toml/reader.h"

namespace opaline::scene {

/// The media of a scene file, by name.
using Media = std::map<std::string, Medium, std::less<>>;

/// Reads [media].
Media readMedia(const TomlTable& root);

/// The medium of that name, one of the file's or a measured one. Throws Error, naming `key` of the
/// table, where there is none.
Medium mediumNamed(const TomlTable& table, std::string_view key, const std::string& name,
                   const Media& media);

}  // namespace opaline::scene
