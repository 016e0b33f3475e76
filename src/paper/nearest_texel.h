#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace opaline::paper {

/// For every texel of a square map the index of the nearest texel whose coverage is not zero, by
/// Euclidean distance, exact; the lower index of two at the same distance. A texel with coverage is
/// its own nearest. Without any coverage every entry is 0. Rows first, then columns, as in the
/// distance transform of Felzenszwalb and Huttenlocher 2012.
std::vector<std::uint32_t> nearestCoveredTexel(std::span<const std::uint32_t> coverage,
                                               std::uint32_t size);

}  // namespace opaline::paper
