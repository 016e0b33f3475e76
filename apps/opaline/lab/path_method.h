#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "cli/command_line.h"
#include "cli/json.h"
#include "opaline/log.h"
#include "reference/geometry.h"
#include "reference/irradiance.h"
#include "reference/path/path_run.h"
#include "reference/path/path_tracer.h"
#include "reference/picture.h"

namespace opaline::app {

/// --path of the reference and the options that go with it.
class PathMethod {
 public:
  void addTo(CommandLine& line);

  bool wanted() const { return wanted_; }
  /// Throws UsageError for such options without --path, and for a checkpoint that the picture or
  /// the report would overwrite.
  void check(const std::filesystem::path& output,
             const std::optional<std::filesystem::path>& report) const;
  /// The checkpoint's file, which is written during the run.
  const std::optional<std::filesystem::path>& checkpoint() const { return checkpoint_; }

  /// Traces light until a limit is reached, and makes a picture of the light that left. Adds facts
  /// to `report`.
  reference::Picture make(const reference::Geometry& geometry,
                          const reference::Irradiance& irradiance,
                          reference::PictureOptions picture, bool quiet, const LogCallback& log,
                          Json& report) const;

 private:
  void resume(reference::PathTracer& tracer) const;
  double run(reference::PathTracer& tracer, const reference::BlockError& error, bool quiet) const;

  bool wanted_ = false;
  bool any_ = false;  ///< whether an option was given that needs --path
  reference::PathOptions options_;
  reference::PathLimits limits_;
  int pathsOfPixel_ = reference::PictureOptions{}.pathsOfPixel;
  std::optional<std::filesystem::path> checkpoint_;
};

/// Warns where so much light slipped through gaps of the surface that the result is not the truth.
void warnOfLostLight(const reference::PathTracer& tracer, const LogCallback& log);

}  // namespace opaline::app
