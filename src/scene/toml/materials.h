#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "opaline/scene_file.h"
#include "scene/material.h"
#include "scene/toml/reader.h"

namespace opaline::scene {

/// A material of a scene file, and what it makes of an object.
struct TomlMaterial {
  MaterialSource source;
  Translucent translucent;  ///< unless `opaque` is set
  std::optional<OpaqueMaterial> opaque;
};

/// Looks a medium up by its name. Error messages use the table and the key.
using FindMedium =
    std::function<Medium(const TomlTable& table, std::string_view key, const std::string& name)>;

/// Reads the [materials] of a scene; their textures are beside `file`. A color means what the
/// material says it does, or else what `colorModel` says.
std::map<std::string, TomlMaterial> readMaterials(const TomlTable& root,
                                                  const std::filesystem::path& file,
                                                  ColorModel colorModel,
                                                  const FindMedium& findMedium);

}  // namespace opaline::scene
