#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "opaline/types.h"

namespace opaline::core {

/// A side of a triangle, from `corner` to the next.
struct HalfEdge {
  std::uint32_t low = 0;   ///< the smaller vertex
  std::uint32_t high = 0;  ///< the larger vertex
  std::uint32_t triangle = 0;
  std::uint8_t corner = 0;
  bool forward = true;  ///< runs from low to high
};

/// All sides of all triangles, those of one edge next to each other.
std::vector<HalfEdge> sortedHalfEdges(std::span<const Triangle> triangles);

/// Calls `visit(std::span<const HalfEdge>)` once for every edge.
template <typename Visit>
void forEachEdge(std::span<const HalfEdge> sorted, Visit&& visit) {
  std::size_t begin = 0;
  while (begin < sorted.size()) {
    std::size_t end = begin + 1;
    while (end < sorted.size() && sorted[end].low == sorted[begin].low &&
           sorted[end].high == sorted[begin].high) {
      ++end;
    }
    visit(sorted.subspan(begin, end - begin));
    begin = end;
  }
}

/// The triangles with their vertices replaced by `names`.
std::vector<Triangle> renamed(std::span<const Triangle> triangles,
                              std::span<const std::uint32_t> names);

}  // namespace opaline::core
