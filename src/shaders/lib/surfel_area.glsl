// The area of a surfel in this frame. Needs, before it, BINDING_SOURCES.
#ifndef OPALINE_LIB_SURFEL_AREA
#define OPALINE_LIB_SURFEL_AREA
#include "lib/texels.glsl"
#include "shared/surfels.h"

TEXELS(BINDING_SOURCES, sources);  // Source

// mm²
float areaOfSurfel(uint surfel) {
  float area = 0.0;
  for (uint s = 0u; s < sourcesPerSurfel; ++s) area += texelOf(sources, 2 * int(sourcesPerSurfel * surfel + s)).w;
  return area;
}

#endif
