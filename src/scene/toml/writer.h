#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "opaline/file.h"
#include "opaline/scene.h"
#include "scene/scene_settings.h"

namespace opaline::scene {

/// Everything that a .toml scene can say.
struct SceneDescription {
  struct ObjectMedium {
    std::string object;
    Medium medium;
  };

  SceneSource source;
  /// The middle of the box around all objects in the rest pose, mm: what the file counts places
  /// from.
  Vec3 centreMm{};
  std::vector<ObjectMedium> media;  ///< of every translucent object without a material
  bool mediaOfAll = true;           ///< there are no others
  std::vector<DirectionalLight> directional;
  std::vector<PointLight> points;
  std::vector<SpotLight> spots;
  std::vector<AreaLight> areas;
  Rgb ambient{};
  Camera camera;
  std::optional<Ground> ground;  ///< its height from the centre
  std::vector<Deformer> deformers;
  SceneFileSettings settings;
};

/// A scene that was loaded from `source`, whatever became of its media, lights, camera and
/// deformers since. Throws Error for an environment without a file.
SceneDescription describe(const Scene& scene, SceneSource source, SceneFileSettings settings);

/// Writes a .toml scene that loads as what is described: every number comes back bit by bit, but
/// for places that are nearer than 1e-8 of the way to the centre to the origin of the coordinates.
/// Paths are relative to its folder but where only the root of the file system is common. Throws
/// UsageError for a name that does not end in .toml, and Error for what no scene file can say, as
/// two objects of one name and different media, or when it cannot be written. Returns
/// where it is.
std::filesystem::path writeScene(const Target& target, const SceneDescription& description);

}  // namespace opaline::scene
