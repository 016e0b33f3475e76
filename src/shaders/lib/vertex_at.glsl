// Vertices of this frame. Needs BINDING_VERTICES, the first of two.
#ifndef OPALINE_LIB_VERTEX_AT
#define OPALINE_LIB_VERTEX_AT
#include "lib/position_at.glsl"
#include "lib/texels.glsl"

TEXELS(BINDING_VERTICES + 1, normals);

// Unit; w is below 0 where the body is mirrored.
vec4 normalOf(uint vertex) {
  return texelOf(normals, int(vertex));
}

#endif
