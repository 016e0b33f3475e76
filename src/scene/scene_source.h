#pragma once

#include <filesystem>
#include <vector>

#include "opaline/scene_file.h"

namespace opaline::scene {

/// The same source, for whichever folder is the current one later.
SceneSource withAbsolutePaths(SceneSource source);

/// What would have made the scene times `factor` in the first place, to rounding: with that size
/// of its models, whose diagonals are given, and all of them and their objects as much farther
/// apart.
void rescale(SceneSource& source, double factor, const std::vector<double>& modelDiagonalsMm);

}  // namespace opaline::scene
