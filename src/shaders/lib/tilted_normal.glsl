// Normals of pieces of surfels where a texture gives them: means over the pieces, found at rest, as parts of what
// moves with the surface. Needs, before it, BINDING_TILTS.
#ifndef OPALINE_LIB_TILTED_NORMAL
#define OPALINE_LIB_TILTED_NORMAL
#include "lib/unit.glsl"

// xy: the direction of the tangent, as parts of the triangle's edges from its first corner; its length is that of the
// mean of the texture's normals, or 0 without a texture. zw: the components of that mean, as a unit vector, along the
// tangent and along normal × tangent.
layout(std430, set = 0, binding = BINDING_TILTS) readonly buffer Tilts { vec4 tilts[]; };

// For a mesh with these edges and this normal.
vec3 tiltedNormal(uint piece, vec3 toSecond, vec3 toThird, vec3 normal) {
  vec4 tilt = tilts[piece];
  if (tilt.xy == vec2(0.0)) return normal;
  vec3 tangent = tilt.x * toSecond + tilt.y * toThird;
  vec3 along = unitOr(tangent - dot(tangent, normal) * normal, vec3(0.0));
  float up = sqrt(max(1.0 - dot(tilt.zw, tilt.zw), 0.0));
  return unitOr(tilt.z * along + tilt.w * cross(normal, along) + up * normal, normal);
}

// What light from one side gives normals that differ, over what it gives their mean direction.
float evenness(uint piece) {
  vec4 tilt = tilts[piece];
  return tilt.xy == vec2(0.0) ? 1.0 : length(tilt.xy);
}

#endif
