// What samples see that meet no surface: lights, and the environment behind everything.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/samples.glsl"
#include "lib/sight.glsl"
#include "lib/tile.glsl"
#include "lib/visible_light.glsl"

layout(set = 0, binding = 1, r32ui) readonly uniform uimage2DArray words;  // triangles, plus one
layout(set = 0, binding = 2) uniform sampler2D environment;
layout(set = 0, binding = 3, rgba32f) writeonly uniform image2D radiance;

layout(push_constant) uniform Push {
  vec4 ambient;  // rgb: radiance on top of the environment's
  uint samples;
  float fills;  // 1: the environment is seen; 0: nothing
};

#include "lib/environment_seen.glsl"

vec4 seenAlong(Sight sight, float level) {
  vec3 ofLight;
  if (!isinf(distanceToLights(sight.origin, sight.direction, true, ofLight))) return vec4(ofLight, 1.0);
  return fills * vec4(environmentFrom(sight.direction, level), 1.0);
}

void main() {
  ivec2 pixel = pixelOfInvocation();
  ivec2 size = imageSize(radiance);
  bool inside = all(lessThan(pixel, size));
  float level = levelOfEnvironment(angleOfPixel(size.y) / sqrt(float(samples)));  // what a sample stands for
  vec4 sum = vec4(0.0);
  for (uint i = 0u; i < (inside ? samples : 0u); ++i)  // not by uniforms alone: see lightsAt()
    if (imageLoad(words, ivec3(pixel, i)).r == 0u)
      sum += seenAlong(sightThrough(clipAt(pixel, size, frame.samples[i].xy)), level);
  if (inside) imageStore(radiance, pixel, sum / float(samples));
}
