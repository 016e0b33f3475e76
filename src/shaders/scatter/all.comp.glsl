// A range of all sources, added to the exitance of every visible pixel.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_SOURCES 6
#include "lib/scatter.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D surfacePosition;
layout(set = 0, binding = 2, rgba32f) uniform image2D exitance;

layout(push_constant) uniform Push {
  uint firstSource;
  uint lastSource;
};

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(exitance)))) return;
  vec4 surface = texelFetch(surfacePosition, pixel, 0);
  vec4 value = firstSource == 0u ? vec4(0.0) : imageLoad(exitance, pixel);
  if (surface.w > 0.0) {
    value.rgb += sourceSum(surface.xyz, uint(surface.w) - 1u, firstSource, lastSource);
    value.a = 1.0;
  }
  imageStore(exitance, pixel, value);
}
