// Lays a picture over what others have drawn: its radiance by coverage, at the depth of the nearest
// surface that the pixel sees.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_SEEN 1
#define MESH_BINDING 2
#include "lib/frame.glsl"
#include "lib/seen.glsl"

layout(set = 0, binding = 6) uniform sampler2D radiance;  // by coverage

layout(push_constant) uniform Push {
  vec4 clipDepth;  // the rows for depth of others' matrix from mm to clip space
  vec4 clipW;
  uint layers;      // of surfaces, at most
  uint isReversed;  // depth: nearer is larger
  float scale;      // of the radiance
};

layout(location = 0) out vec4 color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = texelFetch(radiance, pixel, 0);
  if (sum == vec4(0.0)) discard;
  // Where no surface is, lights and sky lie behind everything.
  float depth = isReversed != 0u ? 0.0 : 1.0;
  for (uint layer = 0u; layer < layers; ++layer) {
    uint word = seenWord(pixel, layer);
    if (word == 0u) break;
    vec4 place = vec4(seenPlace(pixel, word).position, 1.0);
    float own = clamp(dot(clipDepth, place) / dot(clipW, place), 0.0, 1.0);
    depth = isReversed != 0u ? max(depth, own) : min(depth, own);
  }
  color = vec4(scale * sum.rgb, min(sum.a, 1.0));
  gl_FragDepth = depth;
}
