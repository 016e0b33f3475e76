// Adds up the surfaces that a pixel sees, which follow each other in the list: always in one order.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "shared/seen.h"

layout(std430, set = 0, binding = 0) readonly buffer SeenList { uint seenList[]; };
layout(std140, set = 0, binding = 1) uniform SeenCounts { SeenCount seenCount; };
layout(std430, set = 0, binding = 2) readonly buffer Light { vec4 light[]; };  // radiance by coverage
layout(set = 0, binding = 3, rgba32f) uniform writeonly image2D radiance;

void main() {
  uint entries = seenCount.groupsEntries.w;
  uint i = linearIndex();
  if (i >= entries || seenList[i] >> seenLayerShift != 0u) return;
  vec4 sum = light[i];
  for (uint next = i + 1u; next < entries && seenList[next] >> seenLayerShift != 0u; ++next)
    sum += light[next];
  int index = int(seenList[i]);
  int width = imageSize(radiance).x;
  imageStore(radiance, ivec2(index % width, index / width), sum);
}
