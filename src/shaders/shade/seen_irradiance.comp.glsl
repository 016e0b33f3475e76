// The irradiance that the surfel at every visible pixel has gathered: the mean over its sources.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/surfels.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0, rgba32f) readonly uniform image2D seen;  // passes::SeenSurfels
layout(std430, set = 0, binding = 1) readonly buffer Sources { Source sources[]; };
layout(set = 0, binding = 2, rgba32f) writeonly uniform image2D irradiance;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(irradiance)))) return;
  float surfel = imageLoad(seen, pixel).x;
  vec4 sum = vec4(0.0);
  if (surfel >= 0.0) {
    uint first = sourcesPerSurfel * uint(surfel);
    for (uint i = first; i < first + sourcesPerSurfel; ++i)
      sum += vec4(sources[i].flux.rgb, sources[i].positionArea.w);
  }
  imageStore(irradiance, pixel, sum.w > 0.0 ? vec4(sum.rgb / sum.w, 1.0) : vec4(0.0));
}
