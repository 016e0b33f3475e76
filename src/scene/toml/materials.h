#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "opaline/scene_file.h"
#include "scene/material.h"
#include "scene/toml/reader.h"

namespace opaline::scene {

/// What an object with a material is made of.
struct TomlMaterial {
  MaterialSource source;
  Translucent translucent;  ///< unless `opaque` is set
  std::optional<OpaqueMaterial> opaque;
};

/// Looks a medium up by its name; the table and the key are for its complaint.
using FindMedium =
    std::function<Medium(const TomlTable& table, std::string_view key, const std::string& name)>;

/// The [materials] of a scene, whose textures are read beside `file`. A color means what the
/// material says, else what `colorModel` does.
std::map<std::string, TomlMaterial> readMaterials(const TomlTable& root,
                                                  const std::filesystem::path& file,
                                                  ColorModel colorModel,
                                                  const FindMedium& findMedium);

}  // namespace opaline::scene
