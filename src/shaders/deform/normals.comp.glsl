// Normals from the moved triangles, for objects whose source gives none that follow: the mean of the
// triangles around a vertex, weighted by their angle there (Thürmer and Wüthrich 1998).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "lib/unit.glsl"
#include "shared/deform.h"

layout(std430, set = 0, binding = 0) readonly buffer Rest { RestVertex rest[]; };
layout(std430, set = 0, binding = 1) readonly buffer Motions { ObjectMotion motions[]; };
layout(std430, set = 0, binding = 2) readonly buffer EdgeRange { uvec2 edgeRange[]; };  // first, number
layout(std430, set = 0, binding = 3) readonly buffer Edges { TriangleEdge edges[]; };
layout(std430, set = 0, binding = 4) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 5) buffer Normals { vec4 normals[]; };

layout(push_constant) uniform Push { uint vertexCount; };

void main() {
  uint v = linearIndex();
  if (v >= vertexCount || motions[rest[v].object].normalsFromMesh == 0u) return;
  vec3 here = positions[v].xyz;
  vec3 sum = vec3(0.0);
  uvec2 range = edgeRange[v];
  for (uint i = range.x; i < range.x + range.y; ++i) {
    vec3 a = positions[edges[i].next].xyz - here;
    vec3 b = positions[edges[i].last].xyz - here;
    vec3 area = cross(a, b);
    float doubled = length(area);
    if (doubled > 0.0) sum += area * (atan(doubled, dot(a, b)) / doubled);
  }
  vec4 before = normals[v];
  normals[v] = vec4(unitOr(before.w * sum, before.xyz), before.w);
}
