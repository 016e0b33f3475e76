#pragma once

#include <filesystem>
#include <vector>

#include "opaline/scene_file.h"

namespace opaline::scene {

/// The same source, independent of the current folder.
SceneSource withAbsolutePaths(SceneSource source);

/// Changes the source to one that makes the scene `factor` times as large, up to rounding: the
/// models get that size, and they and their objects lie that much farther apart. The models'
/// diagonals are given.
void rescale(SceneSource& source, double factor, const std::vector<double>& modelDiagonalsMm);

}  // namespace opaline::scene
