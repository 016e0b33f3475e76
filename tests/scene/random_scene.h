#pragma once

#include <filesystem>

#include "opaline/image.h"
#include "opaline/scene_file.h"

namespace opaline::test {

/// A small environment.
Image sky();

/// The model with random, awkwardly printable values of everything else that a scene can have. Its
/// environment is sky(), written to that file.
LoadedScene randomScene(unsigned seed, const std::filesystem::path& model,
                        const std::filesystem::path& skyFile);

}  // namespace opaline::test
