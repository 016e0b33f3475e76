// The map's irradiance at every visible pixel, between texels by linear interpolation.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define MESH_BINDING 4
#define BINDING_CORNERS 8
#include "lib/frame.glsl"
#include "lib/seen.glsl"
#include "paper/shaders/lib/place.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 2) uniform sampler2D nearFlux;
layout(set = 0, binding = 3, rgba32f) writeonly uniform image2D seen;

// Filters itself, because devices' weights have eight bits.
vec4 fluxAt(vec2 place) {
  ivec2 size = textureSize(nearFlux, 0);
  vec2 at = clamp(place * vec2(size) - 0.5, vec2(0.0), vec2(size - 1));
  ivec2 low = min(ivec2(at), max(size - 2, 0));
  ivec2 high = min(low + 1, size - 1);
  vec2 part = at - vec2(low);
  vec4 above = mix(texelFetch(nearFlux, low, 0), texelFetch(nearFlux, ivec2(high.x, low.y), 0), part.x);
  vec4 below = mix(texelFetch(nearFlux, ivec2(low.x, high.y), 0), texelFetch(nearFlux, high, 0), part.x);
  return mix(above, below, part.y);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(seen)))) return;
  vec4 mean = vec4(0.0);
  uint word = seenWord(pixel, 0u);
  if (word != 0u) mean = fluxAt(nearPlaceOn(triangleOf(word), seenPlace(pixel, word).weights));
  imageStore(seen, pixel, mean.a > 0.0 ? vec4(mean.rgb / mean.a, 1.0) : vec4(0.0));
}
