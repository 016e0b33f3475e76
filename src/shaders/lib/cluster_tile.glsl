// A tile of clusters, for what acts on all of them. A work group has a tile, and its invocations share
// the nodes of the tree of clusters among them. Needs, before it, BINDING_OBJECTS, BINDING_MEDIA, and
// BINDING_TILES, the first of two bindings.
#ifndef OPALINE_LIB_CLUSTER_TILE
#define OPALINE_LIB_CLUSTER_TILE
#define TILE_WORK
#include "lib/boundary.glsl"
#include "lib/texels.glsl"
#include "lib/work_group.glsl"

layout(std430, set = 0, binding = BINDING_TILES) readonly buffer Tiles { ClusterTile tiles[]; };
TEXELS(BINDING_TILES + 1, clusterTexels);  // Cluster

const uint invocationsOfTile = gl_WorkGroupSize.x;

uint tileIndex;
ClusterTile tile;
ObjectData body;
BoundaryMedium medium;
float leastSigma;
vec4 targets[maxClustersOfTile];  // centroid, mm; area, mm². Past the tile's end, its last cluster again
vec4 targetNormals[maxClustersOfTile];  // w: the radius of a disc of that area, mm

// The part of the body's nodes that this invocation looks at in a walk.
uint sliceBegin;
uint sliceEnd;

// Returns false, for all of the work group, where there is no such tile.
bool enterTile(uint tileCount) {
  tileIndex = groupIndex();
  if (tileIndex >= tileCount) return false;
  tile = tiles[tileIndex];
  body = objects[tile.object];
  medium = insideOf(body);
  leastSigma = leastOf(medium.sigma.rgb);
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) {
    uint cluster = min(tile.firstCluster + t, tile.endCluster - 1u);
    targets[t] = texelOf(clusterTexels, texelOfCluster(cluster, 0u));
    targetNormals[t] = texelOf(clusterTexels, texelOfCluster(cluster, 1u));
  }
  uint nodes = body.clusters.y - body.clusters.x;
  uint i = gl_LocalInvocationIndex;
  sliceBegin = body.clusters.x + nodes * i / invocationsOfTile;
  sliceEnd = body.clusters.x + nodes * (i + 1u) / invocationsOfTile;
  return true;
}

float nearestSquared(vec3 place) {
  float least = 3e38;
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) {
    vec3 offset = place - targets[t].xyz;
    least = lesser(least, dot(offset, offset));
  }
  return least;
}

#endif
