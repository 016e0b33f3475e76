// Lists the surfaces that the pixels of a band see. Needs, before it, what lib/listing.glsl needs and BINDING_ENTRIES, and
// after that the first row of the band, as `firstRow`.
#ifndef OPALINE_LIB_SURFACE_LISTING
#define OPALINE_LIB_SURFACE_LISTING
#include "lib/listing.glsl"

// Where the first surface of a pixel is in the list.
layout(std430, set = 0, binding = BINDING_ENTRIES) writeonly buffer Entries { uint entryOfPixel[]; };

void listSurface(uint place, uint width, ivec2 pixel, uint layer) {
  uint index = uint(pixel.y) * width + uint(pixel.x);
  surfaces[place] = index | layer << seenLayerShift;
  if (layer == 0u) entryOfPixel[index - firstRow * width] = place;
}

#endif
