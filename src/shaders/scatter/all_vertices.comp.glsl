// Adds a range of all surfels to the exitance of every vertex of the objects that are summed there.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_SOURCES 6
#include "lib/surfel_sum.glsl"
#include "lib/linear.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Positions { vec4 positions[]; };
layout(std430, set = 0, binding = 2) readonly buffer ObjectOf { uint objectOf[]; };
layout(std430, set = 0, binding = 3) buffer Exitance { vec4 exitances[]; };

layout(push_constant) uniform Push {
  uint vertexCount;
  uint firstSurfel;
  uint endSurfel;
  uint site;
};

void main() {
  uint i = linearIndex();
  if (i >= vertexCount) return;
  ObjectData body = objects[objectOf[i]];
  if (isOpaque(body) || isSummedAtFragments(body, site)) return;
  vec4 value = firstSurfel == 0u ? vec4(0.0) : exitances[i];
  exitances[i] = value + surfelSumOf(positions[i].xyz, body, firstSurfel, endSurfel);
}
