#pragma once

#include <cstdint>
#include <vector>

#include "opaline/scene.h"

namespace opaline::deform {

/// For every vertex the first of those that are one point of one smooth surface: equal position and
/// normal at rest. Along a seam of texture coordinates there are several; normals that are made
/// from triangles are theirs together. In a facetted mesh every vertex is alone.
std::vector<std::uint32_t> smoothGroups(const Mesh& mesh);

}  // namespace opaline::deform
