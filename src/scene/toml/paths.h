#pragma once

#include <filesystem>
#include <string>

namespace opaline::scene {

/// A path that a scene file names, relative to that file.
inline std::filesystem::path beside(const std::filesystem::path& file, const std::string& name) {
  const std::filesystem::path path(name);
  return path.is_absolute() ? path : file.parent_path() / path;
}

}  // namespace opaline::scene
