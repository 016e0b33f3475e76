#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/medium_options.h"
#include "opaline/environment.h"
#include "opaline/framing.h"
#include "opaline/log.h"
#include "opaline/scene.h"
#include "opaline/scene_file.h"
#include "opaline/sequence.h"

namespace opaline::app {

/// One or several SCENE, or --builtin, with their size and medium.
class SceneOptions {
 public:
  void addTo(CommandLine& line);
  /// Replaces everything by another file, which is loaded unchanged.
  void setFile(const std::filesystem::path& file) { *this = {}, files_ = {file}; }
  /// None keeps the file's own size.
  void setDiagonalMm(std::optional<float> diagonalMm) { diagonalMm_ = diagonalMm; }
  std::optional<float> diagonalMm() const { return diagonalMm_; }
  /// Whether any of these options was given.
  bool any() const;
  /// The first file's name without folder and extension, or that of the built-in scene.
  std::string name() const;
  /// Throws UsageError for the name of a medium that nobody knows, before the scene is loaded.
  void checkMedia() const;
  /// Loads or makes the scene. Throws UsageError for an impossible combination of options.
  LoadedScene load(const LogCallback& log) const;

 private:
  /// Those of a scene file; read only where an option names one.
  OwnMedia ownMedia() const;

  std::vector<std::filesystem::path> files_;
  std::optional<std::string> builtIn_;
  std::optional<float> diagonalMm_;
  std::optional<std::filesystem::path> morphTo_;
  MediumOptions medium_;
  options::Chosen<LoadOptions> chosen_;  ///< other options
};

/// --directional, --point, --spot, --rectangle, --disc, --sphere, --tube, --ambient, --environment
/// with its turn and scale, --ground.
class LightOptions {
 public:
  /// Title of their section in the help.
  static constexpr const char* section = "Light; lights given here replace all lights of the scene";

  void addTo(CommandLine& line);
  bool any() const { return any_ || ground_ || !turned_.empty(); }
  /// Once any light is given, only the given lights shine. Turn and intensity apply to the
  /// environment that was given, or else to the scene's own.
  void applyTo(LoadedScene& loaded) const;

 private:
  /// The lighting without the environment.
  Lighting lightingFor(const Scene& scene) const;

  bool any_ = false;
  std::vector<DirectionalLight> directional_;
  std::vector<PointLight> points_;  ///< relative to the centre of the scene's box
  std::vector<SpotLight> spots_;    ///< likewise
  std::vector<AreaLight> areas_;    ///< likewise
  Rgb ambient_{};
  std::optional<Ground> ground_;
  std::optional<std::filesystem::path> environment_;
  options::Chosen<EnvironmentFile> turned_;
};

/// --camera-direction, --camera-position, --camera-target, --fov-degrees.
class CameraOptions {
 public:
  void addTo(CommandLine& line);
  bool any() const {
    return place_.positionMm || place_.targetMm || place_.direction || !chosen_.empty();
  }
  /// A direction turns the scene's camera about its target at the same distance. Any option makes
  /// the camera a chosen one. Throws UsageError for options that contradict each other.
  void applyTo(Scene& scene) const;
  /// Throws the same error before any scene is loaded.
  void check() const;

 private:
  CameraPlace place_;  ///< relative to the centre of the scene's box
  options::Chosen<Camera> chosen_;
};

}  // namespace opaline::app
