#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "opaline/types.h"

namespace opaline::soft_body {

/// Equal cubes around a body, and their corners.
struct Cage {
  std::array<double, 3> originMm{};
  double cellMm = 1;                                ///< edge of a cube
  std::array<std::uint32_t, 3> counts{};            ///< of cubes along each side
  double heightCells = 1;                           ///< of the body, at least 1
  std::vector<std::array<std::uint32_t, 8>> cells;  ///< nodes; corner i lies towards +x, +y, +z by
                                                    ///< its bits 0, 1, 2
  std::array<std::uint32_t, 9> firstOfColour{};  ///< first cell of each colour; cells of a colour
                                                 ///< share no node
  std::vector<std::array<std::uint32_t, 3>> nodes;  ///< place in cells from the origin
  std::vector<bool> held;                           ///< by node
};

/// Makes a cage of `cells` cubes along the body's longest side, or fewer if they would have more
/// than `maxNodes` corners. Corners in the lowest `heldFraction` of the body's height are held, the
/// lowest ones in any case. Throws UsageError for a body that makeVoxels() refuses.
Cage makeCage(std::span<const Vec3> positionsMm, std::span<const Triangle> triangles,
              std::uint32_t cells, double heldFraction, std::size_t maxNodes);

}  // namespace opaline::soft_body
