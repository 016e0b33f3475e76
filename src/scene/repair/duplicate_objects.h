#pragma once

#include <cstddef>

#include "opaline/scene.h"

namespace opaline::scene {

/// Leaves out objects that have the place, the shape and the material of one before them, and
/// returns their number. What moves or changes its material is never among them.
std::size_t removeDuplicateObjects(Scene& scene);

}  // namespace opaline::scene
