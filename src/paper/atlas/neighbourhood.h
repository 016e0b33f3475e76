#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "paper/atlas/atlas.h"

namespace opaline::atlas {

struct NeighbourhoodOptions {
  int mapSize = 512;   ///< edge of the map that the atlas is drawn into, texels
  int reach = 32;      ///< how far beyond a chart's border its tile goes on, texels, > 0
  int alignment = 1;   ///< tiles start at multiples of this, texels, > 0
  int maxSize = 1536;  ///< largest edge of the result, texels; the reach shrinks until it fits
};

/// A second layout of the atlas in which texture neighbours stay surface neighbours across seams.
/// Every chart has a tile of its own: the chart as in the atlas, shifted by whole texels, with an
/// apron around it that shows the surface beyond its border, unfolded triangle by triangle.
struct Neighbourhoods {
  static constexpr std::uint32_t nothing = 0xffffffffU;

  int size = 0;   ///< edge of the square map of all tiles, texels, a multiple of the alignment
  int reach = 0;  ///< the reach for which there was room, texels
  std::vector<std::array<int, 2>> shiftOfChart;  ///< from the atlas to the tile, texels
  std::vector<std::uint32_t> source;  ///< size² entries, rows first: y · mapSize + x of the atlas's
                                      ///< texel that shows the same surface, or nothing
};

/// Depends on the rest pose alone. Where the unfolded surface overlaps itself, the part nearest to
/// the border counts.
Neighbourhoods makeNeighbourhoods(const core::RestSurface& surface, const Atlas& atlas,
                                  const NeighbourhoodOptions& options);

}  // namespace opaline::atlas
