#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "opaline/scene.h"
#include "opaline/sequence.h"
#include "options/picture.h"
#include "scene/scene_source.h"

namespace opaline::scene {

/// What a .toml scene says beyond the scene itself: its [render] table.
struct SceneFileSettings {
  options::Chosen<options::PictureSettings> picture;
  options::NamedSettings named;

  bool operator==(const SceneFileSettings&) const = default;
};

struct LoadedScene {
  Scene scene;
  SceneFileSettings settings;
  SceneSource source;
  /// Where the model is one; `scene` is its first mesh.
  std::shared_ptr<const MeshSequence> sequence;
};

/// Reads a .toml scene: loadScene() without losing the settings and where all of it came from. For
/// any other file the settings are empty.
LoadedScene loadSceneFile(const std::filesystem::path& file, const LoadOptions& options = {});

/// The same of several models in one scene, each as its file has it; a diagonal is that of all
/// together. Throws UsageError for what can only stand alone: a .toml scene, numbered meshes, a
/// morph.
LoadedScene loadSceneFiles(const std::vector<std::filesystem::path>& files,
                           const LoadOptions& options = {});

}  // namespace opaline::scene
