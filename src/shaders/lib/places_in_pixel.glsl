// Places in a pixel from its middle, one in each row and column of four. The first two are opposite each other.
#ifndef OPALINE_LIB_PLACES_IN_PIXEL
#define OPALINE_LIB_PLACES_IN_PIXEL

const vec2 placesInPixel[4] = vec2[4](vec2(-0.125, -0.375), vec2(0.125, 0.375), vec2(0.375, -0.125), vec2(-0.375, 0.125));

#endif
