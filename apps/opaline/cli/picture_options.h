#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/command_line.h"
#include "cli/motion_options.h"
#include "cli/values.h"
#include "opaline/file.h"
#include "opaline/options/picture.h"
#include "opaline/renderer.h"
#include "opaline/scene_file.h"
#include "opaline/tone.h"

namespace opaline::app {

const Choices<Transport>& halfSpaceTransports();  ///< those that a profile fully describes

/// The defaults, overridden by the [render] table of a scene file.
RenderOptions optionsOf(const SceneFileSettings& settings);

/// The [render] table of a file that reproduces what is on the screen. It holds every setting but
/// the device, default or not.
SceneFileSettings settingsOf(const options::PictureSettings& picture, const Scene& scene);

/// How a scene file wants its pictures shown. The exposure follows the light where the file gives
/// none.
ToneOptions toneOf(const SceneFileSettings& settings, const Scene& scene);

/// --transport, --sum, --site, --method and the options that belong to them.
class MethodOptions {
 public:
  void addTo(CommandLine& line);
  /// Applies the options to those that `settings` made of the defaults. Throws UsageError for
  /// options that contradict each other.
  void applyTo(RenderOptions& options, const SceneFileSettings& settings) const;
  /// Throws UsageError for options that only the diffusion source map uses, where none is made, and
  /// for a variable that the method does not have.
  void requireUse(const RenderOptions& options, Aov aov) const;

 private:
  bool paper_ = false;
  options::Chosen<options::PictureSettings> chosen_;
};

/// How a picture looks: --antialias, --no-specular, --roughness, --exposure, --tone, --background.
class LookOptions {
 public:
  void addTo(CommandLine& line);
  /// Throws UsageError for options that contradict each other.
  void applyTo(RenderOptions& options) const;
  /// Whether a value was given that only affects the reflection on the surface.
  bool asksForReflection() const { return chosen_.has("roughness"); }
  /// Whether more than one sample per pixel was asked for.
  bool asksForAntialiasing() const;
  /// Whether a value was given that only affects eight-bit colours.
  bool asksForTone() const;
  /// What was asked for, else what the scene file says.
  ToneOptions tone(const SceneFileSettings& settings, const Scene& scene) const;
  /// Whether no exposure was given, so that the scene's light decides.
  bool exposesByLight(const SceneFileSettings& settings) const {
    return !chosen_.has("exposure") && !settings.picture.has("exposure");
  }

 private:
  options::Chosen<options::PictureSettings> chosen_;
};

/// --aov.
class AovOption {
 public:
  /// The help begins with what is done with the variable. Without `surfels`, the command has
  /// neither these nor the diffusion source map.
  void addTo(CommandLine& line, const std::string& what, bool surfels = true);
  const std::optional<Aov>& aov() const { return aov_; }
  /// The level of the groups of surfels that were asked for.
  const std::optional<int>& treeLevel() const { return treeLevel_; }

 private:
  void take(const Given& given);

  std::optional<Aov> aov_;
  std::optional<int> treeLevel_;
};

/// Throws UsageError for a variable that the method does not have.
void requireMethodFor(Aov aov, const RenderOptions& options);

/// Which picture is written, where, and how it looks.
class PictureOptions {
 public:
  /// `surfels` as for --aov.
  void addTo(CommandLine& line, bool surfels = true);
  /// Throws UsageError for options that contradict each other.
  void applyTo(RenderOptions& options) const;

  Aov aov() const { return aov_.aov().value_or(Aov::Radiance); }
  /// False for variables of the diffusion source map.
  bool seenByCamera() const { return aov() < Aov::DsmPosition; }
  /// Whether a value was given that only affects the reflection on the surface.
  bool asksForReflection() const { return look_.asksForReflection(); }
  bool isExr() const;
  /// Throws UsageError unless -o suits a film, or a still.
  void requireNameFor(bool frames, bool resume, bool chunk) const;
  /// -o, or an unused name in the current folder that begins with the scene's name.
  Target target(const std::string& sceneName, const std::optional<FrameRange>& frames) const;
  /// What was asked for, else what the scene file says.
  ToneOptions tone(const SceneFileSettings& settings, const Scene& scene) const {
    return look_.tone(settings, scene);
  }
  /// The exposure that the scene's light has chosen; none where it does not show.
  std::optional<std::string> noteOnExposure(const SceneFileSettings& settings,
                                            const ToneOptions& tone) const;

 private:
  options::Chosen<options::PictureSettings> chosen_;  // the size
  LookOptions look_;
  AovOption aov_;
  std::optional<std::filesystem::path> file_;
};

}  // namespace opaline::app
