// How much of what 2×2 pixels mirror is sky.
#ifndef OPALINE_LIB_SKY_BLOCK
#define OPALINE_LIB_SKY_BLOCK

const float unknownShare = -1.0;  // the pixels are not of one surface, or mirror too sharply

#endif
