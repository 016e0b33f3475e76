#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/half_edges.h"
#include "opaline/types.h"

namespace opaline::scene {

using core::forEachEdge;
using core::HalfEdge;
using core::renamed;
using core::sortedHalfEdges;

/// For every vertex the smallest vertex that is the same point of the surface. Open edges that
/// coincide are sewn together. Surfaces stay apart if they only touch in a point, or if the edges
/// are already taken.
std::vector<std::uint32_t> sewn(std::span<const Vec3> positions,
                                std::span<const Triangle> triangles);

/// How many sides belong to one triangle only, and how many closed lines they form. Lines that
/// touch in a point are separate. The surface must be sewn and its half edges sorted.
struct Borders {
  std::size_t sides = 0;
  std::size_t loops = 0;
};
Borders bordersOf(std::span<const Triangle> triangles, std::span<const HalfEdge> edges);

}  // namespace opaline::scene
