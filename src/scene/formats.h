#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "opaline/log.h"
#include "scene/raw_scene.h"

namespace opaline::scene {

/// Files longer than this are refused.
constexpr std::size_t longestFileBytes = 2'147'483'647;

/// What a model is read for.
struct ModelOptions {
  bool wantsCoordinates = false;  ///< of textures that others will put on it
  ColorModel colorModel = ColorModel::Observed;
};

/// What a loader gets: the bytes of the file, the file itself for messages and for what lies beside
/// it, and whom to tell.
struct Input {
  std::filesystem::path file;
  std::span<const std::byte> bytes;
  LogCallback log;
  ModelOptions options;
};

/// Each throws Error, naming the file, for bytes that are not what they say.
RawScene loadPly(const Input& input);
RawScene loadObj(const Input& input);
RawScene loadGltf(const Input& input);

/// By magic or by extension; .toml is not among them.
RawScene loadModel(const std::filesystem::path& file, const LogCallback& log,
                   const ModelOptions& options = {});

void note(const LogCallback& log, std::string_view message);

/// Marble, as objects without a medium are.
Medium defaultMedium();

}  // namespace opaline::scene
