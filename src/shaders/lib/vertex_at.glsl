// Vertices of this frame. Needs BINDING_VERTICES, the first of two.
#ifndef OPALINE_LIB_VERTEX_AT
#define OPALINE_LIB_VERTEX_AT
#include "lib/position_at.glsl"

layout(set = 0, binding = BINDING_VERTICES + 1) uniform samplerBuffer normals;

// Unit; w is below 0 where the body is mirrored.
vec4 normalOf(uint vertex) {
  return texelFetch(normals, int(vertex));
}

#endif
