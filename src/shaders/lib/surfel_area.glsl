// The area of a surfel in this frame. Needs, before it, BINDING_SOURCES.
#ifndef OPALINE_LIB_SURFEL_AREA
#define OPALINE_LIB_SURFEL_AREA
#include "shared/surfels.h"

layout(set = 0, binding = BINDING_SOURCES) uniform samplerBuffer sources;  // Source

// mm²
float areaOfSurfel(uint surfel) {
  float area = 0.0;
  for (uint s = 0u; s < sourcesPerSurfel; ++s) area += texelFetch(sources, 2 * int(sourcesPerSurfel * surfel + s)).w;
  return area;
}

#endif
