// The surfaces that pixels see. Needs, before it, BINDING_SEEN and what lib/mesh.glsl needs.
#ifndef OPALINE_LIB_SEEN
#define OPALINE_LIB_SEEN
#include "lib/mesh.glsl"
#include "lib/samples.glsl"

layout(set = 0, binding = BINDING_SEEN) uniform usampler2DArray seenWords;

uint seenWord(ivec2 pixel, uint layer) {
  return texelFetch(seenWords, ivec3(pixel, layer), 0).r;
}

// Clip space over w, at `place` from the pixel's centre.
vec2 seenClip(ivec2 pixel, vec2 place) {
  return clipAt(pixel, textureSize(seenWords, 0).xy, place);
}

// The surface is looked at in the middle of the samples that see it.
MeshPlace seenPlace(ivec2 pixel, uint word) {
  return placeOn(triangleOf(word), seenClip(pixel, middleOf(samplesOf(word))));
}

#endif
