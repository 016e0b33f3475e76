// Sums over the work group of a tile, one for each of its clusters.
#ifndef OPALINE_LIB_TILE_SUM
#define OPALINE_LIB_TILE_SUM
#include "lib/cluster_tile.glsl"

shared vec3 tileTerms[invocationsOfTile / 4u][maxClustersOfTile];  // for subgroups of at least 4

// Every invocation of the group calls it for each of the clusters.
void addToTile(uint target, vec3 term) {
  vec3 sum = subgroupAdd(term);
  if (subgroupElect()) tileTerms[gl_SubgroupID][target] = sum;
}

// Every invocation calls it after that; those without a cluster get 0.
vec3 sumOfTile(uint target) {
  barrier();
  vec3 sum = vec3(0.0);
  if (target >= maxClustersOfTile) return sum;
  for (uint g = 0u; g < gl_NumSubgroups; ++g) sum += tileTerms[g][target];
  return sum;
}

#endif
