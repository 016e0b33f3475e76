#pragma once

#include <filesystem>

#include "viewer/panels/controls.h"

namespace opaline::app::viewer {

/// How the window was left.
struct ViewerState {
  int width = 1280;
  int height = 800;
  bool panels = true;
  bool handles = true;
  bool scaleBar = true;
  controls::Sections openSections;
  std::filesystem::path openFolder;  ///< where a file was opened from last; empty: none was
};

/// From a file in that folder; as usual where there is none, or none that makes sense.
ViewerState readState(const std::filesystem::path& folder);

/// Does nothing where the folder is empty or cannot be written to: the next window is as usual
/// then.
void writeState(const std::filesystem::path& folder, const ViewerState& state);

}  // namespace opaline::app::viewer
