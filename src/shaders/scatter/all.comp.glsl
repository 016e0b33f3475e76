// A range of all surfels, added to the exitance of every visible pixel whose object wants it there;
// others keep what their vertices have.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 4
#define BINDING_MEDIA 5
#define BINDING_SOURCES 6
#include "lib/surfel_sum.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D surfacePosition;
layout(set = 0, binding = 2, rgba32f) uniform image2D exitance;
layout(set = 0, binding = 3) uniform sampler2D vertexExitance;

layout(push_constant) uniform Push {
  uint firstSurfel;
  uint endSurfel;
  uint site;
};

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(exitance)))) return;
  vec4 surface = texelFetch(surfacePosition, pixel, 0);
  vec4 value = firstSurfel == 0u ? vec4(0.0) : imageLoad(exitance, pixel);
  if (surface.w > 0.0) {
    ObjectData body = objects[uint(surface.w) - 1u];
    if (isSummedAtFragments(body, site)) {
      value += surfelSumOf(surface.xyz, body, firstSurfel, endSurfel);
    } else if (firstSurfel == 0u) {
      value = texelFetch(vertexExitance, pixel, 0);
    }
  }
  imageStore(exitance, pixel, value);
}
