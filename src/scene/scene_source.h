#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "opaline/environment.h"
#include "opaline/scene.h"
#include "opaline/types.h"
#include "options/scene.h"

namespace opaline::scene {

/// Where an object stands, seen from its model: a matrix, or else scaled, turned about x, then y,
/// then z, all fixed axes, and moved.
struct Placement {
  std::optional<std::array<double, 16>> rows;  ///< affine, row by row, lengths in mm
  Vec3 translationMm{};
  Vec3 rotationDegrees{};
  double scale = 1;
};

/// A model and what is done to it before it meets the others.
struct ModelSource {
  std::filesystem::path file;        ///< or builtin:bear, builtin:teapot
  std::optional<double> diagonalMm;  ///< that it is scaled to; none: the file's unit
  std::optional<std::filesystem::path> morphTo;
  std::optional<Placement> placement;  ///< of all of it, its lights and camera too

  bool isBuiltIn() const { return file.string().starts_with("builtin:"); }
};

/// What a scene file says of a material.
struct MaterialSource {
  bool isOpaque = false;
  std::optional<std::string> medium;  ///< of a translucent one its name, else its appearance
  options::Chosen<Appearance> appearance;
  options::Chosen<OpaqueMaterial> opaque;
  std::map<std::string, std::filesystem::path> textures;  ///< by key
};

/// The files a scene was made of and what was done to them. Paths are absolute.
struct SceneSource {
  std::optional<std::filesystem::path> sceneFile;  ///< the .toml that says all of this
  std::vector<ModelSource> models;                 ///< at least one
  std::map<std::string, Placement> placements;  ///< by the object's name; others stand as they are
  std::map<std::string, MaterialSource> materials;
  std::map<std::string, std::string> materialOfObject;  ///< by the object's name, where one is said
  std::optional<EnvironmentFile> environment;
};

/// Of a scene that is loaded from a model's file with these options, or is built in.
SceneSource sourceOf(const std::filesystem::path& model, const LoadOptions& options);

/// The same for whichever folder is the current one later.
SceneSource withAbsolutePaths(SceneSource source);

/// What would have made the scene times `factor` in the first place, to rounding: with that size
/// of its models, whose diagonals are given, and all of them and their objects as much farther
/// apart.
void rescale(SceneSource& source, double factor, const std::vector<double>& modelDiagonalsMm);

}  // namespace opaline::scene
