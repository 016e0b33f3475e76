#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "cli/command_line.h"
#include "cli/json.h"
#include "opaline/log.h"
#include "reference/geometry.h"
#include "reference/irradiance.h"
#include "reference/path/path_run.h"
#include "reference/path/path_tracer.h"
#include "reference/picture.h"

namespace opaline::app {

/// One of the pictures that a command makes, and who is told of it.
struct PictureRun {
  std::optional<int> frame;  ///< of a film
  std::string progress;      ///< what comes before its own progress, such as "frame 2/3, "
  bool quiet = false;
  LogCallback log;
};

/// In the report: why the checkpoint of a picture was not saved, or null.
constexpr const char* unsavedCheckpoint = "unsaved_checkpoint";

/// --path of the reference and the options that go with it.
class PathMethod {
 public:
  void addTo(CommandLine& line);

  bool wanted() const { return wanted_; }
  /// Throws UsageError for such options without --path, for a checkpoint that the picture or the
  /// report would overwrite, and for one name where every frame needs its own.
  void check(const std::filesystem::path& output,
             const std::optional<std::filesystem::path>& report, bool films) const;
  /// The checkpoint's file, which is written during the run, or the name of those of all frames.
  const std::optional<std::filesystem::path>& checkpoint() const { return checkpoint_; }
  /// All that decides the picture besides the scene, for its stamp.
  Json describe() const;

  /// Traces light until a limit is reached, and makes a picture of the light that left. Adds facts
  /// to `report`.
  reference::Picture make(const reference::Geometry& geometry,
                          const reference::Irradiance& irradiance,
                          reference::PictureOptions picture, const PictureRun& run,
                          Json& report) const;

 private:
  std::optional<std::filesystem::path> checkpointOf(const PictureRun& run) const;
  void resume(const PictureRun& run, reference::PathTracer& tracer) const;
  double trace(const PictureRun& run, const reference::BlockError& error,
               reference::PathTracer& tracer, std::string& unsaved) const;

  bool wanted_ = false;
  bool any_ = false;  ///< whether an option was given that needs --path
  reference::PathOptions options_;
  reference::PathLimits limits_;
  int pathsOfPixel_ = reference::PictureOptions{}.pathsOfPixel;
  std::optional<std::filesystem::path> checkpoint_;
};

/// Warns where so much light slipped through gaps of the surface, or was lost where bodies overlap,
/// that the result is not the truth.
void warnOfLostLight(const reference::PathTracer& tracer, const reference::Scene& scene,
                     const LogCallback& log);

}  // namespace opaline::app
