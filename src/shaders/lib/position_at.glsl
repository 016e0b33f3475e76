// Where vertices lie in this frame, read as texels: Mesa's software device reads storage word by word. Needs BINDING_VERTICES.
#ifndef OPALINE_LIB_POSITION_AT
#define OPALINE_LIB_POSITION_AT

layout(set = 0, binding = BINDING_VERTICES) uniform samplerBuffer positions;

vec3 positionOf(uint vertex) {
  return texelFetch(positions, int(vertex)).xyz;
}

#endif
