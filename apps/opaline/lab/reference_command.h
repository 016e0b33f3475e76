#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "cli/command_line.h"
#include "cli/json.h"
#include "cli/motion_options.h"
#include "cli/paths.h"
#include "cli/picture_options.h"
#include "cli/scene_options.h"
#include "lab/path_method.h"
#include "opaline/file.h"
#include "opaline/render_options.h"
#include "reference/picture.h"

namespace opaline::app {

/// The options of `opaline reference`.
struct ReferenceCommand {
  SceneOptions scene;
  LightOptions lights;
  CameraOptions camera;
  MotionOptions motion;
  PictureOptions picture;
  bool integral = false;
  bool ambientOcclusion = false;
  std::optional<Transport> transport;
  std::optional<double> tolerance;  ///< none: the usual one
  PathMethod path;
  std::optional<reference::Region> region;
  int every = 1;
  bool resume = false;
  std::optional<std::filesystem::path> report;
  bool quiet = false;
  bool json = false;

  void addTo(CommandLine& line);
  /// Refuses options that contradict each other or that only the GPU renderer supports, before any
  /// work.
  void check() const;
  RenderOptions options(const SceneFileSettings& settings) const;
  reference::PictureOptions pictureOptions(const RenderOptions& render) const;
  double toleranceOf() const;
  /// Files that are replaced, `output` among them where its name was given.
  std::vector<Output> outputs(const Target& output) const;
  /// All that decides a picture besides scene and picture options, for its stamp.
  Json describeMethod(const RenderOptions& render) const;

 private:
  void addMethodTo(CommandLine& line);
  void checkVariable() const;
};

}  // namespace opaline::app
