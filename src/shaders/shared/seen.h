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

/// A surface's word has its triangle and 1 below, and from this bit a bit for each sample that sees
/// it: all eight where every one does. It is 0 where a pixel has no such surface.
OPALINE_SEEN_CONSTANT seenSamplesShift = 24u;
OPALINE_SEEN_CONSTANT everySample = 0xffu;
OPALINE_SEEN_CONSTANT maxTriangles = (1u << seenSamplesShift) - 2u;

/// An entry of the list of surfaces has the pixel's index in the picture below, and from this bit
/// which of its surfaces it is.
OPALINE_SEEN_CONSTANT seenLayerShift = 28u;
/// An entry that fills up a subgroup.
OPALINE_SEEN_CONSTANT noSurface = ~0u;

/// What takes long goes over the list of surfaces by several dispatches of so many.
OPALINE_SEEN_CONSTANT seenOfPart = 1u << 20u;

/// Light is interpolated in blocks of so many pixels across, or twice as many (lib/blocks.glsl).
OPALINE_SEEN_CONSTANT widthOfBlock = 4u;
/// A work group has so many of the smaller ones across.
OPALINE_SEEN_CONSTANT blocksOfGroup = 8u;

/// Groups of a dispatch over a list, x y z, and w: entries, with those that fill up. The list of
/// surfaces has one for the whole and then one for each part, which has no w.
struct SeenCount {
  uvec4 groupsEntries;
};

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif
