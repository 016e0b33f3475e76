#pragma once

#include <cstdint>
#include <vector>

#include "opaline/scene.h"

namespace opaline::deform {

/// For every vertex, the first vertex that is the same point of a smooth surface: its position and
/// normal at rest are equal. Along a seam of texture coordinates there are several such vertices;
/// they share a normal computed from triangles. In a facetted mesh every vertex is alone.
std::vector<std::uint32_t> smoothGroups(const Mesh& mesh);

}  // namespace opaline::deform
