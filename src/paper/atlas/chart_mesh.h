#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "paper/atlas/charts.h"

namespace opaline::atlas {

using Point2 = std::array<double, 2>;

/// A chart as a surface of its own: every vertex has one fan, so where the chart touches itself
/// (at a vertex, or along a cut) it has several vertices.
struct ChartMesh {
  std::vector<Triangle> triangles;                    ///< in the chart's order
  std::vector<Point3> positions;                      ///< mm
  std::vector<std::array<std::uint32_t, 2>> borders;  ///< directed edges, the chart on their left
  std::vector<std::vector<std::uint32_t>> loops;      ///< the same as cycles, the longest first
  int handles = 0;                                    ///< 0 for a disc with or without holes
};

ChartMesh extract(const Topology& topology, const Chart& chart);

}  // namespace opaline::atlas
