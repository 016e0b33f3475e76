#pragma once

#include <algorithm>
#include <cstdint>

#include "passes/mechanics.h"

namespace opaline::passes {

/// How shaders with lib/raster.glsl divide a picture: each work group draws some triangles within a
/// band of rows. Fewer triangles get more bands, so that all of a device has work.
struct RasterBands {
  std::uint32_t groups = 0;  ///< along the triangles
  std::uint32_t count = 0;
  std::uint32_t rows = 0;  ///< of each band except the last
};

inline RasterBands rasterBands(std::uint32_t triangles, std::uint32_t rows) {
  constexpr std::uint32_t mostGroups = 32768;  // every device dispatches that many along an axis
  constexpr std::uint32_t groupsWanted = 2048;
  constexpr std::uint32_t leastBands = 2;
  constexpr std::uint32_t mostBands = 256;
  const std::uint32_t groups = std::clamp((triangles + groupSize - 1) / groupSize, 1U, mostGroups);
  const std::uint32_t wanted = std::clamp(groupsWanted / groups, leastBands, mostBands);
  const std::uint32_t rowsOfBand = std::max((rows + wanted - 1) / wanted, 1U);
  return {.groups = groups, .count = (rows + rowsOfBand - 1) / rowsOfBand, .rows = rowsOfBand};
}

}  // namespace opaline::passes
