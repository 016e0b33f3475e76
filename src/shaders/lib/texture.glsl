// Textures in a storage buffer: half floats, linear in light, with all their levels. Needs, before
// it, BINDING_TEXELS.
#ifndef OPALINE_LIB_TEXTURE
#define OPALINE_LIB_TEXTURE
#include "shared/opaque.h"

layout(std430, set = 0, binding = BINDING_TEXELS) readonly buffer Texels { uvec2 texels[]; };

// A place on a surface in the mesh's coordinates, and how far these change over a pixel.
struct TexturePlace {
  vec2 at;
  vec2 right;
  vec2 down;
};

// The texel in [0, size) that stands for any place.
int wrapped(int at, int size, uint wrap) {
  if (wrap == 2u) return clamp(at, 0, size - 1);
  int period = wrap == 1u ? 2 * size : size;
  at -= period * int(floor(float(at) / float(period)));
  at = clamp(at, 0, period - 1);
  return at < size ? at : 2 * size - 1 - at;
}

// Wraps from a texture's bits.
uint wrapU(uint bits) {
  return bits & 3u;
}
uint wrapV(uint bits) {
  return bits >> wrapVShift & 3u;
}

vec4 texelAt(uint first, ivec2 size, ivec2 at, uint bits) {
  uint x = uint(wrapped(at.x, size.x, wrapU(bits)));
  uint y = uint(wrapped(at.y, size.y, wrapV(bits)));
  uvec2 texel = texels[first + y * uint(size.x) + x];
  return vec4(unpackHalf2x16(texel.x), unpackHalf2x16(texel.y));
}

// Bilinear, in one level.
vec4 levelAt(uint first, ivec2 size, vec2 at, uint bits, bool edges) {
  vec2 place = at * vec2(size) - 0.5;
  if (edges) return texelAt(first, size, ivec2(floor(place + 0.5)), bits);
  ivec2 low = ivec2(floor(place));
  vec2 part = place - vec2(low);
  vec4 above = mix(texelAt(first, size, low, bits), texelAt(first, size, low + ivec2(1, 0), bits), part.x);
  vec4 below = mix(texelAt(first, size, low + ivec2(0, 1), bits),
                   texelAt(first, size, low + ivec2(1, 1), bits), part.x);
  return mix(above, below, part.y);
}

// Trilinear.
vec4 textureAtLevel(uvec4 place, vec2 at, float level) {
  uint first = place.x;
  ivec2 size = ivec2(place.y & 0xffffu, place.y >> 16u);
  level = clamp(level, 0.0, float(place.z - 1u));
  // All go round equally often. With as many rounds as each needs, invocations of a subgroup get each
  // other's levels on Mesa's software device.
  for (uint l = 0u; l + 1u < mostTextureLevels; ++l) {
    bool below = l < uint(level);
    first += below ? uint(size.x * size.y) : 0u;
    size = below ? max(size / 2, ivec2(1)) : size;
  }
  float part = fract(level);
  vec4 fine = levelAt(first, size, at, place.w, level == 0.0 && (place.w & textureHasEdges) != 0u);
  if (part == 0.0) return fine;
  first += uint(size.x * size.y);
  return mix(fine, levelAt(first, max(size / 2, ivec2(1)), at, place.w, false), part);
}

const float mostProbes = 8.0;

// Takes off pairs of whole tiles, which say nothing but how far out coordinates are.
vec2 near0(vec2 at, uint bits) {
  vec2 tile = 2.0 * floor(0.5 * at);
  return at - vec2(wrapU(bits) == 2u ? 0.0 : tile.x, wrapV(bits) == 2u ? 0.0 : tile.y);
}

// Anisotropic: several probes along the longer side of the pixel.
vec4 sampled(TextureData data, TexturePlace place) {
  mat2 map = transpose(mat2(data.rowU.xy, data.rowV.xy));
  const vec2 furthest = vec2(1e7);
  vec2 at = clamp(map * place.at + vec2(data.rowU.z, data.rowV.z), -furthest, furthest);
  at = near0(at, data.place.w);
  vec2 size = vec2(data.place.y & 0xffffu, data.place.y >> 16u);
  vec2 right = clamp(map * place.right, -furthest, furthest);
  vec2 down = clamp(map * place.down, -furthest, furthest);
  float across = length(size * right);
  float along = length(size * down);
  vec2 axis = across > along ? right : down;
  float longer = max(across, along);
  float shorter = max(min(across, along), longer / mostProbes);
  float probes = longer > 1.0 ? clamp(ceil(longer / max(shorter, 1.0)), 1.0, mostProbes) : 1.0;
  float level = log2(max(longer / probes, 1e-6));
  vec4 sum = vec4(0.0);
  for (float i = 0.0; i < probes; i += 1.0)
    sum += textureAtLevel(data.place, at + ((i + 0.5) / probes - 0.5) * axis, level);
  return sum / probes;
}

bool isThere(TextureData data) {
  return data.place.z != 0u;
}

#endif
