#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/tile.glsl"
// Counts how often each pixel was taken.
layout(binding = 0, r32f) uniform image2D runs;

void main() {
  ivec2 pixel = pixelOfInvocation();
  if (all(lessThan(pixel, imageSize(runs)))) imageStore(runs, pixel, imageLoad(runs, pixel) + 1.0);
}
