// Vertices of this frame, read as texels: Mesa's software device reads storage word by word. Needs BINDING_VERTICES, the
// first of two.
#ifndef OPALINE_LIB_VERTEX_AT
#define OPALINE_LIB_VERTEX_AT

layout(set = 0, binding = BINDING_VERTICES) uniform samplerBuffer positions;
layout(set = 0, binding = BINDING_VERTICES + 1) uniform samplerBuffer normals;

vec3 positionOf(uint vertex) {
  return texelFetch(positions, int(vertex)).xyz;
}

// Unit; w is below 0 where the body is mirrored.
vec4 normalOf(uint vertex) {
  return texelFetch(normals, int(vertex));
}

#endif
