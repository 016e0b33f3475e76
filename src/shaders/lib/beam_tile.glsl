// Sums, at every cluster of a tile, over the points of light on its group's list: bindings and what a
// node is to the tile.
#ifndef OPALINE_LIB_BEAM_TILE
#define OPALINE_LIB_BEAM_TILE
#define LONG_WORK
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_POINTS 2
#define BINDING_STRENGTHS 3
#define BINDING_BEAM_NODES 4
#define BINDING_TILES 5
#define BINDING_NODE_OBJECTS 11
#include "lib/beam.glsl"
#include "lib/beam_node.glsl"
#include "lib/cluster_tile.glsl"
#include "lib/group_place.glsl"
#include "lib/tile_sum.glsl"
#include "lib/way_between.glsl"

layout(std430, set = 0, binding = 7) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 8) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 9) readonly buffer Lists { uint lists[]; };
layout(std430, set = 0, binding = 10) buffer Sums { vec4 sums[]; };

layout(push_constant) uniform Push {
  uint tileCount;
  float openingAngle;
  uint adds;     // 1: to what other light and other nodes gave
  uint isFirst;  // 1: of the dispatches for these lights
  uint lights;
  uint clusterCount;
  uint room;     // of a list
  uint firstTree;  // of the lights'
  uint nodeCount;  // of a tree
  uint groupCount;
};

uint light;  // of which the sum is

uint beamOf(uint cluster) {
  return light * clusterCount + cluster;
}

BeamNode readListed(uint node) {
  return readBeamNode((firstTree + light) * nodeCount + node);
}

uint startOfTilesList() {
  return startOfList((firstTree + light) * groupCount + tile.group, room);
}

vec3 tileLight[maxClustersOfTile];

Around aroundTile() {
  vec3 low = targets[0].xyz;
  vec3 high = targets[0].xyz;
  [[unroll]] for (uint t = 1u; t < maxClustersOfTile; ++t) {
    low = min(low, targets[t].xyz);
    high = max(high, targets[t].xyz);
  }
  vec3 middle = 0.5 * (low + high);
  float squared = 0.0;
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) {
    vec3 offset = targets[t].xyz - middle;
    squared = max(squared, dot(offset, offset));
  }
  return Around(middle, sqrt(squared));
}

// What a node on the list is to the tile. Those of a kind are summed side by side, since a device may
// execute both sides of every branch.
const uint nodeNearby = 0u;
const uint nodeApart = 1u;
const uint pointsNearby = 2u;
const uint pointsApart = 3u;

// From beyond that many of a tile's radii, light changes little over it.
const float apartInRadii = 4.0;

uint kindOf(uint entry, Around around, float sigma) {
  BeamNode node = readListed(entry & ~openedBit);
  uint cluster = clusterOf(node);
  bool listed = (entry & openedBit) != 0u;
  // The tile's own are always opened: parts of them are discs.
  bool own = listed && cluster >= tile.firstCluster && cluster < tile.endCluster;
  float nearest = nearestOf(node, around);
  bool opened = own || listed && !isFar(nearest * nearest, node.extent.x, sigma, openingAngle);
  float reached = apartInRadii * around.radius + (opened ? 2.0 * node.extent.z : 0.0);
  bool apart = !own && leastDistance(node, around) > reached;
  return (opened ? pointsNearby : nodeNearby) + (apart ? 1u : 0u);
}

// The list is sorted by kinds in parts.
// Of an invocation, which has two bits for each.
const uint entriesAtOnce = 256u / invocationsOfTile;
const uint sizeOfPart = entriesAtOnce * invocationsOfTile;
shared uint sorted[sizeOfPart];

// Where each kind ends.
uvec4 sortPart(uint list, uint begin, uint end, Around around, float sigma) {
  begin += gl_LocalInvocationIndex;
  uint mine = begin < end ? (end - begin + invocationsOfTile - 1u) / invocationsOfTile : 0u;
  uint kinds = 0u;
  uint counts[2] = uint[2](0u, 0u);  // of two kinds each, in halves
  for (uint e = 0u; e < mine; ++e) {
    uint k = begin + e * invocationsOfTile;
    uint kind = kindOf(lists[list + 1u + k], around, sigma);
    kinds |= kind << 2u * e;
    uint one = 1u << 16u * (kind & 1u);
    counts[0] += kind < 2u ? one : 0u;
    counts[1] += kind < 2u ? 0u : one;
  }
  uint all[2];
  uint place[2];
  place[0] = groupPlaceFor(counts[0], all[0]);
  barrier();
  place[1] = groupPlaceFor(counts[1], all[1]);
  uvec4 ends = uvec4(all[0] & 0xffffu, all[0] >> 16u, all[1] & 0xffffu, all[1] >> 16u);
  uvec4 at = uvec4(place[0] & 0xffffu, place[0] >> 16u, place[1] & 0xffffu, place[1] >> 16u);
  ends.y += ends.x;
  ends.z += ends.y;
  ends.w += ends.z;
  at.yzw += ends.xyz;
  for (uint e = 0u; e < mine; ++e) {
    uint k = begin + e * invocationsOfTile;
    uint kind = kinds >> 2u * e & 3u;
    uint node = lists[list + 1u + k] & ~openedBit;
    uvec4 its = uvec4(equal(uvec4(kind), uvec4(0u, 1u, 2u, 3u)));
    uvec4 put = its * at;
    sorted[put.x + put.y + put.z + put.w] = node;
    at += its;
  }
  barrier();
  return ends;
}

// For the tile's `target`, that sum and what `own` adds to it, times a factor.
void putLight(uint target, vec3 sum, vec3 own, vec3 factor) {
  if (target >= tile.endCluster - tile.firstCluster) return;
  uint i = tile.firstCluster + target;
  if (isFirst != 0u) sum += own;
  sum *= factor;
  if (!boundsDiffusion(ranges[i].kind)) sum = vec3(0.0);
  sums[i] = vec4(adds != 0u ? sums[i].rgb + sum : sum, 0.0);
}

#endif
