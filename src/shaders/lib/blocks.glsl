// Blocks of pixels whose light is interpolated from 3×3 knots: of 8×8 pixels, and of 4×4, which are quarters of those.
// Knots on a block's last side are the first of the next. Needs, before it, lib/neighbours.glsl.
#ifndef OPALINE_LIB_BLOCKS
#define OPALINE_LIB_BLOCKS

const int narrowBlock = int(widthOfBlock);
const int wideBlock = 2 * narrowBlock;

// What is known of a narrow block, or zero: every pixel has a sum of its own.
const uint isNarrow = 1u;  // one smooth surface fills it
const uint isWide = 2u;    // it is a quarter of a wide one that such a surface fills
const uint isDone = 3u;    // its light is known

uint narrowBlocksAcross() {
  return uint(textureSize(seenWords, 0).x + narrowBlock - 1) / uint(narrowBlock);
}

uint blockOf(ivec2 pixel) {
  ivec2 block = (pixel - ivec2(0, firstRow)) / narrowBlock;
  return uint(block.y) * narrowBlocksAcross() + uint(block.x);
}

bool isKnot(ivec2 pixel, int width) {
  return all(equal(pixel % (width / 2), ivec2(0)));
}

#endif
