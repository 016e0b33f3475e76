#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/medium_options.h"
#include "opaline/environment.h"
#include "opaline/log.h"
#include "opaline/scene.h"
#include "opaline/scene_file.h"
#include "opaline/sequence.h"

namespace opaline::app {

/// SCENE, one or several, or --builtin, its size and its medium.
class SceneOptions {
 public:
  void addTo(CommandLine& line);
  /// Another file instead, of which everything else is as it says.
  void setFile(const std::filesystem::path& file) { *this = {}, files_ = {file}; }
  /// Without one, the size is as the file has it.
  void setDiagonalMm(std::optional<float> diagonalMm) { diagonalMm_ = diagonalMm; }
  std::optional<float> diagonalMm() const { return diagonalMm_; }
  /// Whether any of them was given.
  bool any() const;
  /// The first file's name without folder and extension, or that of the built-in scene.
  std::string name() const;
  /// Reads or makes it. Throws UsageError for a mixture of options that makes no sense.
  LoadedScene load(const LogCallback& log) const;

 private:
  std::vector<std::filesystem::path> files_;
  std::optional<std::string> builtIn_;
  std::optional<float> diagonalMm_;
  std::optional<std::filesystem::path> morphTo_;
  MediumOptions medium_;
  options::Chosen<LoadOptions> chosen_;  ///< of the other options
};

/// --directional, --point, --spot, --rectangle, --disc, --sphere, --tube, --ambient, --environment
/// and what turns and scales it, --ground.
class LightOptions {
 public:
  void addTo(CommandLine& line);
  bool any() const { return any_ || ground_ || !turned_.empty(); }
  /// As soon as a light was given, only what was given shines. Turn and intensity are of its
  /// environment or else of the scene's own.
  void applyTo(LoadedScene& loaded) const;

 private:
  /// Without the environment.
  Lighting lightingFor(const Scene& scene) const;

  bool any_ = false;
  std::vector<DirectionalLight> directional_;
  std::vector<PointLight> points_;  ///< relative to the centre of the scene's box
  std::vector<SpotLight> spots_;    ///< the same
  std::vector<AreaLight> areas_;    ///< the same
  Rgb ambient_{};
  std::optional<Ground> ground_;
  std::optional<std::filesystem::path> environment_;
  options::Chosen<EnvironmentFile> turned_;
};

/// --camera-direction, --camera-position, --camera-target, --fov-degrees.
class CameraOptions {
 public:
  void addTo(CommandLine& line);
  bool any() const { return direction_ || position_ || target_ || !chosen_.empty(); }
  /// A direction turns the scene's camera about its target; its distance stays. Whatever else is
  /// given, the camera is chosen. Throws UsageError for a mixture that contradicts itself.
  void applyTo(Scene& scene) const;
  /// The same of the mixture, before any scene is there.
  void check() const;

 private:
  std::optional<Vec3> direction_;
  std::optional<Vec3> position_;  ///< relative to the centre of the scene's box
  std::optional<Vec3> target_;    ///< the same
  options::Chosen<Camera> chosen_;
};

/// A sentence for each medium beside which the scene is so large or so small that its size was
/// probably not meant.
std::vector<std::string> notesOnSize(const Scene& scene);

}  // namespace opaline::app
