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

const Choices<Transport>& halfSpaceTransports();  ///< those of which a profile tells all

/// The [render] table of a scene file over the defaults.
RenderOptions optionsOf(const SceneFileSettings& settings);

/// The [render] table of a file that shows what is on the screen: everything, whether or not it is
/// the default, but the device.
SceneFileSettings settingsOf(const options::PictureSettings& picture, const Scene& scene);

/// How a scene file wants its pictures shown, with the exposure that suits the light where it names
/// none.
ToneOptions toneOf(const SceneFileSettings& settings, const Scene& scene);

/// --transport, --sum, --site, --method and what shapes each of them.
class MethodOptions {
 public:
  void addTo(CommandLine& line);
  /// Onto what `settings` made of the defaults. Throws UsageError for a mixture that contradicts
  /// itself.
  void applyTo(RenderOptions& options, const SceneFileSettings& settings) const;
  /// Throws UsageError for what only the diffusion source map has a use for, where none is made,
  /// and for a variable that the method does not have.
  void requireUse(const RenderOptions& options, Aov aov) const;

 private:
  bool paper_ = false;
  options::Chosen<options::PictureSettings> chosen_;
};

/// How a picture looks: --antialias, --no-specular, --roughness, --exposure, --tone, --background.
class LookOptions {
 public:
  void addTo(CommandLine& line);
  /// Throws UsageError for a mixture that contradicts itself.
  void applyTo(RenderOptions& options) const;
  /// Whether a value was given that only matters to the reflection on the surface.
  bool asksForReflection() const { return chosen_.has("roughness"); }
  /// Whether more samples than one a pixel were asked for.
  bool asksForAntialiasing() const;
  /// Whether a value was given that only matters to colours of eight bits.
  bool asksForTone() const;
  /// What was asked for, else what the scene file says.
  ToneOptions tone(const SceneFileSettings& settings, const Scene& scene) const;
  /// Whether nobody has said how to expose, so that the scene's light decides.
  bool exposesByLight(const SceneFileSettings& settings) const {
    return !chosen_.has("exposure") && !settings.picture.has("exposure");
  }

 private:
  options::Chosen<options::PictureSettings> chosen_;
};

/// What is written and how it looks.
class PictureOptions {
 public:
  /// What a command makes besides stills of what the camera sees.
  struct Kinds {
    bool films = true;
    bool sourceMap = true;
  };
  void addTo(CommandLine& line, const Kinds& kinds);
  /// Throws UsageError for a mixture that contradicts itself.
  void applyTo(RenderOptions& options) const;

  Aov aov() const { return aov_.value_or(Aov::Radiance); }
  /// False for what lies in the diffusion source map.
  bool seenByCamera() const { return aov() < Aov::DsmPosition; }
  /// Whether a value was given that only matters to the reflection on the surface.
  bool asksForReflection() const { return look_.asksForReflection(); }
  bool isExr() const;
  /// Throws UsageError unless -o suits a film, or a still.
  void requireNameFor(bool frames, bool resume, bool chunk) const;
  /// The same where there is nothing but stills.
  void requireNameOfStill() const;
  /// -o, or a name after the scene's in the current folder under which nothing is replaced.
  Target target(const std::string& sceneName, const std::optional<FrameRange>& frames) const;
  bool hasFile() const { return file_.has_value(); }
  /// What was asked for, else what the scene file says.
  ToneOptions tone(const SceneFileSettings& settings, const Scene& scene) const {
    return look_.tone(settings, scene);
  }
  /// Where the scene's light has chosen an exposure that shows, which.
  std::optional<std::string> noteOnExposure(const SceneFileSettings& settings,
                                            const ToneOptions& tone) const;

 private:
  void takeAov(const Given& given);

  options::Chosen<options::PictureSettings> chosen_;  // the size
  LookOptions look_;
  std::optional<Aov> aov_;
  std::optional<int> treeLevel_;
  std::optional<std::filesystem::path> file_;
};

}  // namespace opaline::app
