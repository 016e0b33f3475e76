#pragma once

#include <filesystem>

#include <toml++/toml.h>

namespace opaline::scene {

/// Reads a file of TOML. Throws Error, which names the line.
toml::table parseToml(const std::filesystem::path& file);

}  // namespace opaline::scene
