#pragma once

#include <array>
#include <string>
#include <vector>

#include "opaline/scene.h"

namespace opaline::app {

/// Edges of the box around an object.
std::array<double, 3> sizeMm(const Object& object);

/// Sentences about objects that are so large or so small beside how far light goes in them that
/// their size was probably not meant: of each medium the farthest off, with how many others.
std::vector<std::string> notesOnSize(const Scene& scene);

}  // namespace opaline::app
