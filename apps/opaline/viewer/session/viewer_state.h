#pragma once

#include <filesystem>

#include "viewer/panels/controls.h"

namespace opaline::app::viewer {

/// The state in which the user left the window.
struct ViewerState {
  int width = 1280;
  int height = 800;
  bool panels = true;
  bool handles = true;
  bool scaleBar = true;
  controls::Sections openSections;
  std::filesystem::path openFolder;  ///< folder of the last opened file; empty: none
};

/// Reads the state from a file in that folder. The defaults stand in where there is none, or none
/// that makes sense.
ViewerState readState(const std::filesystem::path& folder);

/// Does nothing where `folder` is empty or cannot be written to; the next window then has the
/// defaults.
void writeState(const std::filesystem::path& folder, const ViewerState& state);

}  // namespace opaline::app::viewer
