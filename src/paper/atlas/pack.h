#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "paper/atlas/chart_mesh.h"

namespace opaline::atlas {

/// What is laid out: the border of a flat chart, closed loops that do not cross.
struct Outline {
  std::vector<Point2> places;                         ///< mm
  std::vector<std::array<std::uint32_t, 2>> borders;  ///< indices into places
  double area = 0;                                    ///< mm²
};

/// uv = scale · rotation(places) + offset
struct Placement {
  double cosine = 1;
  double sine = 0;
  Point2 offset{};
};

struct Layout {
  double scale = 0;  ///< uv units per mm, the same for all charts
  std::vector<Placement> placements;
};

/// Lays charts out in the unit square at the largest common scale found, `gutter` texels of a map
/// of `mapSize` apart; less only where there are more charts than such a map has room for.
Layout pack(const std::vector<Outline>& outlines, int mapSize, int gutter);

}  // namespace opaline::atlas
