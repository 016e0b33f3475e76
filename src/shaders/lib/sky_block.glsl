// What is known of 2×2 pixels: how much of what they mirror is sky.
#ifndef OPALINE_LIB_SKY_BLOCK
#define OPALINE_LIB_SKY_BLOCK

const float unknownShare = -1.0;  // the pixels are not of one surface, or mirror too sharply

#endif
