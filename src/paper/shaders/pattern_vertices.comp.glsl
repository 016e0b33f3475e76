// The pattern at every vertex: the eight far samples, which change slowly over the surface, and for
// the paper's VTF the near block with them. One medium at a time.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_PATTERN 6
#define BINDING_POSITION 7
#define BINDING_FLUX 8
#include "paper/shaders/lib/pattern_sum.glsl"
#include "lib/linear.glsl"
#include "paper/shaders/lib/place.glsl"

layout(constant_id = 1) const uint withNearBlock = 0u;

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer Corners { AtlasCorner corners[]; };  // one per vertex
layout(std430, set = 0, binding = 3) writeonly buffer Exitance { vec4 exitances[]; };
layout(set = 0, binding = 9) uniform sampler2D farPosition;  // means over cells
layout(set = 0, binding = 10) uniform sampler2D farFlux;
layout(std430, set = 0, binding = 11) readonly buffer Charts { ChartPlace charts[]; };
layout(std430, set = 0, binding = 12) readonly buffer FarPlaces { FarPlace farPlaces[]; };  // 8 per vertex

layout(push_constant) uniform Push {
  uint vertexCount;
  uint medium;
};

// Reads means over cells: pieces of surface are small nearby and large far away.
vec3 farSum(uint vertex, vec3 position, MediumData medium) {
  vec4 piece = pattern.entries[2u + pattern.head.nearSamples].value;
  vec3 sum = vec3(0.0);
  for (uint i = 8u * vertex; i < 8u * vertex + 8u; ++i) {
    FarPlace far = farPlaces[i];
    if (far.weight == 0.0) continue;
    vec2 place = vec2(far.u, far.v);
    vec3 offset = textureLod(farPosition, place, 0.0).xyz - position;
    sum += far.weight * textureLod(farFlux, place, 0.0).rgb *
           reflectanceProfile(medium.profile, dot(offset, offset) * piece.rgb + pattern.head.farSquareMm2);
  }
  return sum * piece.a;
}

void main() {
  uint i = linearIndex();
  if (i >= vertexCount) return;
  AtlasCorner corner = corners[i];
  if (objects[corner.object].table.x != medium) return;
  vec3 position = positions[i].xyz;
  vec3 sum = farSum(i, position, media[medium]);
  float evaluations = 8.0;
  if (withNearBlock != 0u) {
    sum += nearSum(position, media[medium], nearPlace(corner, charts[corner.chart]));
    evaluations += float(nearEvaluations());
  }
  exitances[i] = vec4(sum, evaluations);
}
