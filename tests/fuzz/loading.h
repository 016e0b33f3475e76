#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

#include "opaline/scene.h"
#include "scene/formats.h"

namespace opaline::fuzz {

/// A file in a folder of this process's own, where models of "cube.ply", "cube_1.ply", "cube_2.ply"
/// and pictures "sky.hdr" and "texture.png" stand already.
std::filesystem::path fileOf(std::string_view name, std::string_view bytes);

/// The scene is sound, also at some moments of its motion, or an Error is thrown that says why not.
void expectSoundOrRefused(const std::function<Scene()>& load);

/// The same of a model's bytes.
void expectSoundOrRefused(scene::RawScene (*load)(const scene::Input&), std::string_view name,
                          std::string_view bytes);

/// What reads, or throws an Error that says why not.
void expectReadOrRefused(const std::function<void()>& read);

inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace opaline::fuzz
