#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "opaline/types.h"

namespace opaline::soft_body {

/// Cubes in rows along x, then y, then z.
struct Voxels {
  std::array<double, 3> originMm{};
  double cellMm = 1;
  std::array<std::uint32_t, 3> counts{};
  std::vector<bool> filled;

  std::size_t index(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    return x + std::size_t{counts[0]} * (y + std::size_t{counts[1]} * z);
  }
};

/// The cubes that a mesh meets or encloses, `cells` of them along the longest side of its box. They
/// begin where the mesh does in y and stand around its middle in x and z. Throws UsageError for a
/// mesh without triangles, with corners that do not exist or are not finite or beyond 1e18 mm, or
/// without extent.
Voxels makeVoxels(std::span<const Vec3> positionsMm, std::span<const Triangle> triangles,
                  std::uint32_t cells);

}  // namespace opaline::soft_body
