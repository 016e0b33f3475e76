// The pattern at every vertex: the eight far samples, which change slowly over the surface, and for
// the paper's VTF the near block with them.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_PATTERN 6
#define BINDING_POSITION 7
#define BINDING_FLUX 8
#include "lib/scatter.glsl"
#include "lib/linear.glsl"
#include "lib/place.glsl"

layout(constant_id = 1) const uint withNearBlock = 0u;

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer Corners { AtlasCorner corners[]; };  // one a vertex
layout(std430, set = 0, binding = 3) writeonly buffer Exitance { vec4 exitances[]; };
layout(set = 0, binding = 9) uniform sampler2D farPosition;  // means over cells
layout(set = 0, binding = 10) uniform sampler2D farFlux;
layout(std430, set = 0, binding = 11) readonly buffer Charts { ChartPlace charts[]; };
layout(std430, set = 0, binding = 12) readonly buffer FarPlaces { vec2 farPlaces[]; };  // 8 a vertex

layout(push_constant) uniform Push { uint vertexCount; };

// Means over cells: pieces of surface are small nearby and large far away.
vec3 farSum(uint vertex, vec3 position, uint object) {
  MediumData medium = media[objects[object].table.x];
  vec3 weight = pattern[medium.tables.y + 2u + medium.tables.z].value.rgb;
  vec3 sum = vec3(0.0);
  for (uint i = 8u * vertex; i < 8u * vertex + 8u; ++i) {
    vec2 place = farPlaces[i];
    if (place.x < 0.0) continue;  // beyond the surface's border
    vec3 offset = textureLod(farPosition, place, 0.0).xyz - position;
    sum += textureLod(farFlux, place, 0.0).rgb *
           reflectanceProfile(medium.profile, dot(offset, offset) + medium.boundary.w);
  }
  return sum * weight;
}

void main() {
  uint i = linearIndex();
  if (i >= vertexCount) return;
  AtlasCorner corner = corners[i];
  vec3 position = positions[i].xyz;
  vec3 sum = farSum(i, position, corner.object);
  if (withNearBlock != 0u)
    sum += nearSum(position, corner.object, nearPlace(corner, charts[corner.chart]));
  exitances[i] = vec4(sum, 1.0);
}
