#pragma once

#include <cstddef>

#include "opaline/scene.h"

namespace opaline::scene {

/// Removes objects that have the place, shape and material of an earlier one, and returns their
/// number. Objects that move or change their material always stay.
std::size_t removeDuplicateObjects(Scene& scene);

}  // namespace opaline::scene
