// Sums of light at the clusters of a tile, from what is kept of its list (lib/beam_coefficients.glsl), and what is
// written of them.
#ifndef OPALINE_LIB_BEAM_SUM
#define OPALINE_LIB_BEAM_SUM
#include "lib/beam_tile.glsl"
#include "lib/halves.glsl"
#include "lib/tile_sum.glsl"

layout(std430, set = 0, binding = 7) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 10) buffer Sums { vec4 sums[]; };
TEXELS(12, coefficients);
layout(std430, set = 0, binding = 13) readonly buffer Kept { uint kept[]; };

void addNode(uint node);
void expandNode(uint node, vec3 middle);

// Adds a leaf by the coefficients at that place.
void addKept(uint place, uint cluster) {
  vec3 strength = strengthOf(beamOf(cluster)).rgb;
  int first = int(place * texelsOfPoints);
  float halves[4u * texelsOfPoints];
  [[unroll]] for (uint i = 0u; i < texelsOfPoints; ++i) {
    vec4 texel = texelOf(coefficients, first + int(i));
    [[unroll]] for (uint c = 0u; c < 4u; ++c) halves[4u * i + c] = texel[c];
  }
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; t += 2u) {
    vec2 red = unpacked(halves[3u * t / 2u]);
    vec2 green = unpacked(halves[3u * t / 2u + 1u]);
    vec2 blue = unpacked(halves[3u * t / 2u + 2u]);
    tileLight[t] += strength * vec3(red.x, green.x, blue.x);
    tileLight[t + 1u] += strength * vec3(red.y, green.y, blue.y);
  }
}

// Adds all that is kept of the tile. Returns how much of its list that is.
uint sumKept(vec3 middle) {
  if (roomOfKept == 0u) return 0u;
  uint counts = countsOfTile();
  uint first = kept[counts];
  uint roomOfTile = kept[counts + 1u];
  uint entries = kept[counts + 2u];
  uint near = kept[counts + 3u];
  uint apart = kept[counts + 4u];
  uint leaves = kept[counts + 5u];
  uint words = wordsFrom(first);
  uint end = words + 2u * roomOfTile;
  uint i = gl_LocalInvocationIndex;
  for (uint k = i; k < near; k += invocationsOfTile) addNode(kept[words + roomOfTile + k]);
  for (uint k = i; k < apart; k += invocationsOfTile) expandNode(kept[end - 1u - k], middle);
  for (uint k = i; k < leaves; k += invocationsOfTile) addKept(first + k, kept[words + k]);
  return entries;
}

// Writes for the tile's `target` that sum and what `own` adds to it, times a factor.
void putLight(uint target, vec3 sum, vec3 own, vec3 factor) {
  if (target >= tile.endCluster - tile.firstCluster) return;
  uint i = tile.firstCluster + target;
  if (isFirst != 0u) sum += own;
  sum *= factor;
  if (!boundsDiffusion(ranges[i].kind)) sum = vec3(0.0);
  sums[i] = vec4(adds != 0u ? sums[i].rgb + sum : sum, 0.0);
}

#endif
