#pragma once

#include <array>
#include <vector>

#include "paper/atlas/atlas.h"

namespace opaline::atlas {

/// What the atlas's triangles cover of a texel.
struct TexelArea {
  float area = 0;                 ///< texels, 0 to 1
  std::array<float, 2> moment{};  ///< area times the offset of its centroid from the texel's centre
};

/// Exactly, for every texel of a square map: mapSize² entries, rows first.
std::vector<TexelArea> texelAreas(const Atlas& atlas, int mapSize);

}  // namespace opaline::atlas
