// Blocks of pixels whose light is interpolated from 3×3 knots: 8×8 pixels, or 4×4, a quarter of those. Knots on a
// block's last side are the first of the next. An invocation has a narrow block, and a work group a square of them.
// Needs, before it, lib/neighbours.glsl.
#ifndef OPALINE_LIB_BLOCKS
#define OPALINE_LIB_BLOCKS
#include "lib/morton.glsl"

const int narrowBlock = int(widthOfBlock);
const int wideBlock = 2 * narrowBlock;
const int pixelsOfBlock = narrowBlock * narrowBlock;

// What is known of a narrow block. Where it is zero, every pixel has a sum of its own.
const uint isNarrow = 1u;  // one smooth surface fills it
const uint isWide = 2u;    // it is a quarter of a wide one that such a surface fills
const uint isDone = 3u;    // its light is known

uint blockOf(ivec2 pixel) {
  uint across = uint(textureSize(seenWords, 0).x + narrowBlock - 1) / uint(narrowBlock);
  ivec2 block = (pixel - ivec2(0, firstRow)) / narrowBlock;
  return uint(block.y) * across + uint(block.x);
}

bool isKnot(ivec2 pixel, int width) {
  return all(equal(pixel % (width / 2), ivec2(0)));
}

// The first pixel of the invocation's block.
ivec2 firstOfInvocation() {
  uvec2 block = gl_WorkGroupID.xy * blocksOfGroup + placeOfMorton(gl_LocalInvocationIndex);
  return narrowBlock * ivec2(block) + ivec2(0, firstRow);
}

ivec2 pixelOfBlock(ivec2 first, int i) {
  return first + ivec2(i % narrowBlock, i / narrowBlock);
}

#endif
