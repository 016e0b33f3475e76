#pragma once

#include <cstdint>
#include <vector>

#include "paper/atlas/topology.h"

namespace opaline::atlas {

/// The triangles of one chart, connected over shared edges, ascending.
using Chart = std::vector<std::uint32_t>;

/// Divides the triangles that are not degenerate into compact charts of limited curvature.
/// Deterministic.
std::vector<Chart> segment(const Topology& topology);

/// Divides a chart of at least two triangles into two or more, each with at most 15 of every 16.
std::vector<Chart> split(const Topology& topology, const Chart& chart);

}  // namespace opaline::atlas
