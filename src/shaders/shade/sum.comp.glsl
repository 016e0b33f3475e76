// Adds the surfaces that a pixel sees to what lies behind them. They follow each other in the list, so
// the order of the sum is fixed.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "shared/seen.h"

layout(std430, set = 0, binding = 0) readonly buffer SeenList { uint seenList[]; };
layout(std140, set = 0, binding = 1) uniform SeenCounts { SeenCount seenCount; };
layout(std430, set = 0, binding = 2) readonly buffer Light { vec4 light[]; };  // radiance by coverage
layout(set = 0, binding = 3, rgba32f) uniform image2D radiance;

bool isFurtherSurface(uint listed) {
  return listed >> seenLayerShift != 0u && listed != noSurface;
}

void main() {
  uint entries = seenCount.groupsEntries.w;
  uint i = linearIndex();
  if (i >= entries || seenList[i] >> seenLayerShift != 0u) return;
  int index = int(seenList[i]);
  int width = imageSize(radiance).x;
  ivec2 pixel = ivec2(index % width, index / width);
  vec4 sum = imageLoad(radiance, pixel) + light[i];
  for (uint next = i + 1u; next < entries && isFurtherSurface(seenList[next]); ++next)
    sum += light[next];
  imageStore(radiance, pixel, sum);
}
