// What is kept of a tile's list of points of light, by the shape alone: the inner nodes, and what leaves give the
// tile's clusters, whatever their strength. As much is kept as there is room for.
#ifndef OPALINE_LIB_BEAM_COEFFICIENTS
#define OPALINE_LIB_BEAM_COEFFICIENTS
#define LEAVES_BY_THEMSELVES
#include "lib/beam_tile.glsl"
#include "lib/halves.glsl"

layout(std430, set = 0, binding = 12) writeonly buffer Coefficients { vec4 coefficients[]; };
layout(std430, set = 0, binding = 13) writeonly buffer Kept { uint kept[]; };

// Finds what light of unit power that enters through a leaf's cluster gives, in tileLight.
void putPoints(uint cluster);
void putPointsApart(uint cluster, vec3 middle);
void putNode(BeamNode node, vec3 power);
void putNodeApart(BeamNode node, vec3 power, vec3 middle);

// A smaller coefficient could lose its bits, and those of the one it is packed with.
const float leastCoefficient = 1e-30;

// Writes tileLight.
void putCoefficients(uint place) {
  float halves[4u * texelsOfPoints];
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; t += 2u) {
    vec3 low = max(tileLight[t], leastCoefficient);
    vec3 high = max(tileLight[t + 1u], leastCoefficient);
    [[unroll]] for (uint c = 0u; c < 3u; ++c) halves[3u * t / 2u + c] = packed(low[c], high[c]);
  }
  uint first = place * texelsOfPoints;
  [[unroll]] for (uint i = 0u; i < texelsOfPoints; ++i)
    coefficients[first + i] = vec4(halves[4u * i], halves[4u * i + 1u], halves[4u * i + 2u], halves[4u * i + 3u]);
}

// Where the kept part of the tile begins: after those of earlier groups, as if each had its most tiles, and after
// earlier tiles of its own group. No kept part is longer than its list.
uint firstOfTile() {
  uint sum = 0u;
  for (uint g = gl_LocalInvocationIndex; g < tile.group; g += invocationsOfTile)
    sum += lists[startOfList(firstListed * groupCount + g, room)];
  uint all;
  groupPlaceFor(sum, all);
  barrier();
  uint before = 0u;
  while (before < tileIndex && tiles[tileIndex - 1u - before].group == tile.group) ++before;
  return maxTilesOfGroup * all + before * lists[startOfTilesList()];
}

// Begins a leaf, whose light is found next.
uint takeLeaf(uint word, uint node) {
  takeWayFrom(node);
  uint cluster = clusterOf(readListed(node));
  kept[word] = cluster;
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) tileLight[t] = vec3(0.0);
  return cluster;
}

vec3 powerOverEntering(BeamNode leaf) {
  return powerOf(leaf) / leaf.across.w;
}

void keepList(Around around, float sigma) {
  uint list = startOfTilesList();
  uint count = lists[list];
  uint offset = min(firstOfTile(), roomOfKept);
  uint ofTile = min(count, roomOfKept - offset);
  uint first = kindOfBeams * roomOfKept + offset;
  uint words = wordsFrom(first);
  uint nodes = words + ofTile;
  uint lastNode = nodes + ofTile - 1u;
  uint i = gl_LocalInvocationIndex;
  uint begin = 0u;
  uint near = 0u;
  uint apart = 0u;
  uint leaves = 0u;
  while (begin < count) {
    uint end = min(begin + sizeOfPart, count);
    if (end > ofTile) break;
    sortPart(list, begin, end, around, sigma);
    for (uint k = i; k < ends[0]; k += invocationsOfTile) kept[nodes + near + k] = sorted[k];
    for (uint k = ends[0] + i; k < ends[1]; k += invocationsOfTile) kept[lastNode - (apart + k - ends[0])] = sorted[k];
    near += ends[0];
    apart += ends[1] - ends[0];
    uint before = leaves - ends[1];
    for (uint k = ends[1] + i; k < ends[2]; k += invocationsOfTile) {
      takeLeaf(words + before + k, sorted[k]);
      BeamNode leaf = readListed(sorted[k]);
      putNode(leaf, powerOverEntering(leaf));
      putCoefficients(first + before + k);
    }
    for (uint k = ends[2] + i; k < ends[3]; k += invocationsOfTile) {
      takeLeaf(words + before + k, sorted[k]);
      BeamNode leaf = readListed(sorted[k]);
      putNodeApart(leaf, powerOverEntering(leaf), around.middle);
      putCoefficients(first + before + k);
    }
    for (uint k = ends[3] + i; k < ends[4]; k += invocationsOfTile) {
      putPoints(takeLeaf(words + before + k, sorted[k]));
      putCoefficients(first + before + k);
    }
    for (uint k = ends[4] + i; k < ends[5]; k += invocationsOfTile) {
      putPointsApart(takeLeaf(words + before + k, sorted[k]), around.middle);
      putCoefficients(first + before + k);
    }
    leaves += ends[5] - ends[1];
    begin = end;
    barrier();
  }
  if (i != 0u) return;
  uint counts = countsOfTile();
  kept[counts] = first;
  kept[counts + 1u] = ofTile;
  kept[counts + 2u] = begin;
  kept[counts + 3u] = near;
  kept[counts + 4u] = apart;
  kept[counts + 5u] = leaves;
}

#endif
