// What pixels see, as lists of surfaces. Included by C++ and GLSL.
#ifndef OPALINE_SHARED_SEEN_H
#define OPALINE_SHARED_SEEN_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/vec4.hpp>
namespace opaline::shared {
using glm::uvec4;
#define OPALINE_SEEN_CONSTANT constexpr std::uint32_t
#else
#define OPALINE_SEEN_CONSTANT const uint
#endif

/// A surface's word holds its triangle plus 1 and, from this bit on, a bit for each sample that
/// sees it: all eight where every one does. It is 0 where a pixel has no such surface.
OPALINE_SEEN_CONSTANT seenSamplesShift = 24u;
OPALINE_SEEN_CONSTANT everySample = 0xffu;
OPALINE_SEEN_CONSTANT maxTriangles = (1u << seenSamplesShift) - 2u;

/// An entry of the list of surfaces holds the pixel's index in the picture and, from this bit on,
/// which of its surfaces it is.
OPALINE_SEEN_CONSTANT seenLayerShift = 28u;
/// An entry that only fills up a subgroup.
OPALINE_SEEN_CONSTANT noSurface = ~0u;

/// Long work goes over the list of surfaces in several dispatches of this many.
OPALINE_SEEN_CONSTANT seenOfPart = 1u << 20u;

/// Light is interpolated in blocks of this many pixels across, or twice as many (lib/blocks.glsl).
OPALINE_SEEN_CONSTANT widthOfBlock = 4u;
/// A work group has this many of the smaller blocks across.
OPALINE_SEEN_CONSTANT blocksOfGroup = 8u;

/// Groups of a dispatch over a list, x y z, and w: entries, with those that only fill up. The list
/// of surfaces has one for the whole and then one for each part, which has no w.
struct SeenCount {
  uvec4 groupsEntries;
};

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif
