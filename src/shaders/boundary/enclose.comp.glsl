// The interaction lists of a frame, the clusters around each tile, and the share of the solid angle that the body
// fills around each cluster: c_i = Σ (x_j - x_i)·A_j / (4π r³), over the same nodes as the product takes, with
// their first moments.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_TILES 2
#define BINDING_CLUSTER_NODES 4
#include "lib/cluster_walk.glsl"
#include "lib/group_place.glsl"
#include "lib/tile_sum.glsl"

layout(std430, set = 0, binding = 5) writeonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 6) writeonly buffer Lists { uint lists[]; };
layout(std430, set = 0, binding = 7) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 8) writeonly buffer Around { uint around[]; };

layout(push_constant) uniform Push {
  uint tileCount;
  float openingAngle;
  uint roomOfList;
};

// What leaves this many lengths of extinction away does not arrive.
const float furthestFelt = 16.0;

bool isFelt(uint node) {
  float reach = leastSigma * (sqrt(nearestSquared(centroidLinkOf(node).xyz)) - spreadOf(node).x);
  return reach < furthestFelt;
}

float shareOf(vec3 offset, float squared, bool leaf, vec3 vectorArea, float area, Moment moment) {
  float over = inversesqrt(squared);
  float over3 = over * over * over;
  float fills = over3 * dot(offset, vectorArea);
  if (leaf) return fills * coverageOfDisc(squared, area);
  return fills + over3 * (traceOf(moment) - 3.0 * over * over * alongTwice(moment, offset));
}

float largestRadius() {
  float largest = 0.0;
  for (uint k = tile.firstCluster; k < tile.endCluster; ++k) largest = max(largest, spreadOf(ranges[k].node).x);
  return largest;
}

// The next leaf from `at` on, in this invocation's part of the tree, that is felt within that radius of a cluster's
// middle.
uint nextFelt(inout uint at, float radius) {
  while (at < sliceEnd) {
    uint node = at;
    vec4 centroidLink = centroidLinkOf(node);
    uint link = floatBitsToUint(centroidLink.w);
    uint after = afterNode(node, link);
    float reach = spreadOf(node).z + radius;
    bool apart = after <= sliceBegin || nearestSquared(centroidLink.xyz) > reach * reach;
    at = apart || isLeaf(link) ? after : node + 1u;
    if (!apart && isLeaf(link) && node >= sliceBegin) return node;
  }
  return noNode;
}

// Lists the leaves of clusters that are felt anywhere in the tile, in the order of the tree.
void listAround() {
  float radius = largestRadius();
  uint count = 0u;
  uint at = body.clusters.x;
  while (nextFelt(at, radius) != noNode) ++count;
  uint all;
  uint place = groupPlaceFor(count, all);
  uint list = tileIndex * roomOfAround;
  if (gl_LocalInvocationIndex == 0u) around[list] = min(all, roomOfAround - 1u);
  at = body.clusters.x;
  for (; count > 0u && place < roomOfAround - 1u; --count) around[list + 1u + place++] = nextFelt(at, radius);
  barrier();
}

void main() {
  if (!enterTile(tileCount)) return;
  listAround();
  float shares[maxClustersOfTile];
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) shares[t] = 0.0;
  uint felt = 0u;
  uint at = body.clusters.x;
  for (uint node = nextOnWalk(at, openingAngle); node != noNode; node = nextOnWalk(at, openingAngle)) {
    felt += isFelt(node) ? 1u : 0u;
    vec4 centroidLink = centroidLinkOf(node);
    vec3 vectorArea = vectorAreaOf(node);
    float area = spreadOf(node).w;
    uint link = floatBitsToUint(centroidLink.w);
    Moment moment = momentOf(node);
    [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) {
      vec3 offset = centroidLink.xyz - targets[t].xyz;
      float squared = dot(offset, offset);
      bool itself = isLeaf(link) && firstSurfelOf(link) == tile.firstCluster + t;
      if (!itself && squared > leastSquaredMm2)
        shares[t] += shareOf(offset, squared, isLeaf(link), vectorArea, area, moment);
    }
  }

  uint all;
  uint place = groupPlaceFor(felt, all);
  uint list = tileIndex * roomOfList;
  if (gl_LocalInvocationIndex == 0u) lists[list] = all;
  if (all < roomOfList) {
    at = body.clusters.x;
    for (uint node = nextOnWalk(at, openingAngle); node != noNode; node = nextOnWalk(at, openingAngle))
      if (isFelt(node)) lists[list + 1u + place++] = node;
  }

  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) addToTile(t, vec3(shares[t]));
  uint target = gl_LocalInvocationIndex;
  vec3 sum = sumOfTile(target);
  if (target < tile.endCluster - tile.firstCluster)
    clusters[tile.firstCluster + target].vectorArea.w = sum.x / (4.0 * pi);
}
