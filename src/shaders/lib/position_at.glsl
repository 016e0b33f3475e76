// Where vertices lie in this frame, read as texels: Mesa's software device reads storage word by word. Needs BINDING_VERTICES.
#ifndef OPALINE_LIB_POSITION_AT
#define OPALINE_LIB_POSITION_AT
#include "lib/texels.glsl"

TEXELS(BINDING_VERTICES, positions);

vec3 positionOf(uint vertex) {
  return texelOf(positions, int(vertex)).xyz;
}

#endif
