#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "opaline/scene.h"
#include "opaline/sequence.h"
#include "scene/scene_source.h"

namespace opaline::scene {

/// What a .toml scene says beyond the scene itself: its [render] table, unmerged. Names of choices
/// are those of the command line and checked.
struct SceneFileSettings {
  std::optional<int> width;  ///< size = [1024, 1024]
  std::optional<int> height;
  std::optional<std::string> transport;  ///< boundary, better-dipole, dipole
  std::optional<std::string> sum;        ///< tree, all, pattern
  std::optional<std::string> site;       ///< auto, vertex, fragment
  std::optional<float> tolerance;        ///< tolerance, of sum tree
  std::optional<int> maxSources;         ///< max_sources, surfels at most
  std::optional<int> bounces;            ///< bounces, of transport boundary
  std::optional<int> boundarySurfels;    ///< boundary_surfels, at most
  std::optional<int> nearRings;          ///< near_rings
  std::optional<float> nearSpacing;      ///< near_spacing, mean free paths
  std::optional<float> farDistance;      ///< far_distance, mean free paths
  std::optional<int> dsmSize;            ///< dsm_size
  std::optional<int> shadowSize;         ///< shadow_size
  std::optional<bool> specular;          ///< specular
  std::optional<float> roughness;        ///< roughness
  std::optional<int> antialias;          ///< antialias
  std::optional<float> exposureStops;    ///< exposure
  std::optional<std::string> tone;       ///< neutral, none
  std::optional<Rgb> background;         ///< background, linear, in [0, 1]
  std::optional<std::string> device;     ///< device
  std::optional<double> seconds;         ///< seconds, the time to show, ≥ 0
  std::optional<std::string> clip;       ///< clip, by name, or none

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
