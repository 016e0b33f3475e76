// Lists the surfaces that the pixels of a band see, those of a pixel one after the other.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_SURFACES 1
#include "lib/tile.glsl"
#include "lib/listing.glsl"

layout(set = 0, binding = 0) uniform usampler2DArray words;
layout(std430, set = 0, binding = 3) writeonly buffer Entries { uint entryOfPixel[]; };  // of its first surface

layout(push_constant) uniform Push {
  uint samples;
  uint firstRow;
};

uint surfacesOf(ivec2 pixel) {
  if (any(greaterThanEqual(pixel, textureSize(words, 0).xy))) return 0u;
  uint count = 0u;
  // Words of further layers are triangles, with no sample.
  while (count < samples && texelFetch(words, ivec3(pixel, count), 0).r >> seenSamplesShift != 0u) ++count;
  return count;
}

void main() {
  ivec2 pixel = pixelOfInvocation() + ivec2(0, firstRow);
  uint count = surfacesOf(pixel);
  uint first = placesForSurfaces(count);
  uint index = uint(pixel.y * textureSize(words, 0).x + pixel.x);
  for (uint layer = 0u; layer < count; ++layer) surfaces[first + layer] = index | layer << seenLayerShift;
  if (count != 0u) entryOfPixel[index - firstRow * uint(textureSize(words, 0).x)] = first;
}
