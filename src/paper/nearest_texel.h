#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace opaline::paper {

/// For every texel of a square map, the index of the nearest texel with coverage that is not zero,
/// by exact Euclidean distance; of two at the same distance, the lower index. A texel with coverage
/// is its own nearest. Without any coverage every entry is 0. Rows come first, then columns, as in
/// the distance transform of Felzenszwalb and Huttenlocher 2012.
std::vector<std::uint32_t> nearestCoveredTexel(std::span<const std::uint32_t> coverage,
                                               std::uint32_t size);

}  // namespace opaline::paper
