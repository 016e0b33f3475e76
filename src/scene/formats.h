#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "opaline/log.h"
#include "scene/raw_scene.h"

namespace opaline::scene {

/// Files longer than this are refused.
constexpr std::size_t longestFileBytes = 2'147'483'647;

/// What the caller of a loader wants of a model.
struct ModelOptions {
  bool wantsCoordinates = false;  ///< texture coordinates, for textures that a scene file adds
  ColorModel colorModel = ColorModel::Observed;
};

/// What a loader gets: the file's bytes, its path, which serves messages and finds neighbouring
/// files, and whom to tell.
struct Input {
  std::filesystem::path file;
  std::span<const std::byte> bytes;
  LogCallback log;
  ModelOptions options;
};

/// Each throws Error, naming the file, for bytes that are not of its format.
RawScene loadPly(const Input& input);
RawScene loadObj(const Input& input);
RawScene loadGltf(const Input& input);

/// Picks the loader by magic number or by extension. A .toml scene is not accepted.
RawScene loadModel(const std::filesystem::path& file, const LogCallback& log,
                   const ModelOptions& options = {});

/// The extension of a file's name in lower case, with its dot.
std::string lowerExtension(const std::filesystem::path& file);

void note(const LogCallback& log, std::string_view message);

/// Marble, which every object without a medium gets.
Medium defaultMedium();

}  // namespace opaline::scene
