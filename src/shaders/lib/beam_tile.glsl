// Points of light on the list of a tile's group: bindings, and what a node is to the tile.
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
#include "lib/way_between.glsl"

layout(std430, set = 0, binding = 8) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 9) readonly buffer Lists { uint lists[]; };

layout(push_constant) uniform Push {
  uint tileCount;
  float openingAngle;
  uint adds;     // 1: adds to what other light and other nodes gave
  uint isFirst;  // 1: this is the first dispatch for these lights
  uint lights;
  uint clusterCount;
  uint room;         // of a list
  uint firstTree;    // for the lights
  uint firstListed;  // the first of those by which lists are made and leaves are opened
  uint nodeCount;    // of a tree
  uint groupCount;
  uint kindOfBeams;  // 1: light that scatters once
  uint roomOfKept;   // in entries of each kind; 0: nothing is kept
};

uint light;  // the one that is summed

uint beamOf(uint cluster) {
  return light * clusterCount + cluster;
}

BeamNode readLit(uint node) {
  return readBeamNode((firstTree + light) * nodeCount + node);
}

BeamNode readListed(uint node) {
  return readBeamNode((firstListed + light) * nodeCount + node);
}

uint startOfTilesList() {
  return startOfList((firstListed + light) * groupCount + tile.group, room);
}

// Whether light enters the tile's body.
bool isLit() {
  return readLit(body.clusters.x).extent.x >= 0.0;
}

// Where the counts of what is kept of the tile's list are, and the words of what begins at an entry.
uint countsOfTile() {
  return (kindOfBeams * tileCount + tileIndex) * countsOfKept;
}

uint wordsFrom(uint first) {
  return kindsOfBeams * tileCount * countsOfKept + 2u * first;
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

// What an entry of the list is to the tile: a node near it or apart from it, or a leaf near or apart whose points are
// taken one by one. With LEAVES_BY_THEMSELVES other leaves have kinds of their own in between. Entries of a kind are
// summed side by side, since a device may execute both sides of every branch.
#ifdef LEAVES_BY_THEMSELVES
const uint kindsOfEntries = 6u;
#else
const uint kindsOfEntries = 4u;
#endif

// Beyond this many of a tile's radii, light changes little over the tile.
const float apartInRadii = 4.0;

uint kindOf(uint entry, Around around, float sigma) {
  BeamNode node = readListed(entry & ~openedBit);
  uint cluster = clusterOf(node);
  bool listed = (entry & openedBit) != 0u;
  // The tile's own leaves are always opened, because parts of them are discs.
  bool own = listed && cluster >= tile.firstCluster && cluster < tile.endCluster;
  float nearest = nearestOf(node, around);
  bool opened = own || listed && !isFar(nearest * nearest, node.extent.x, sigma, openingAngle);
  // The shape alone does not tell where in the node the power lies.
  bool wide = opened || firstListed != firstTree;
  float reached = apartInRadii * around.radius + (wide ? 2.0 * node.extent.z : 0.0);
  bool apart = !own && leastDistance(node, around) > reached;
  uint asNode = isLeaf(linkOf(node)) ? kindsOfEntries - 4u : 0u;
  return (opened ? kindsOfEntries - 2u : asNode) + (apart ? 1u : 0u);
}

// The list is sorted by kinds in parts.
const uint entriesAtOnce = 256u / invocationsOfTile;  // per invocation
const uint sizeOfPart = entriesAtOnce * invocationsOfTile;
shared uint sorted[sizeOfPart];
uint ends[kindsOfEntries];  // of each kind

void sortPart(uint list, uint begin, uint end, Around around, float sigma) {
  begin += gl_LocalInvocationIndex;
  uint mine = begin < end ? (end - begin + invocationsOfTile - 1u) / invocationsOfTile : 0u;
  uint halves = 0u;  // which of two kinds, a bit for each entry, up to 16
  uint pairs = 0u;   // which pair of kinds, two bits each
  uint counts[kindsOfEntries / 2u];  // two kinds in each, in halves
  [[unroll]] for (uint p = 0u; p < kindsOfEntries / 2u; ++p) counts[p] = 0u;
  for (uint e = 0u; e < mine; ++e) {
    uint k = begin + e * invocationsOfTile;
    uint its = kindOf(lists[list + 1u + k], around, sigma);
    halves |= (its & 1u) << e;
    pairs |= its / 2u << 2u * e;
    uint one = 1u << 16u * (its & 1u);
    [[unroll]] for (uint p = 0u; p < kindsOfEntries / 2u; ++p) counts[p] += its / 2u == p ? one : 0u;
  }
  uint before = 0u;
  uint at[kindsOfEntries];
  [[unroll]] for (uint p = 0u; p < kindsOfEntries / 2u; ++p) {
    uint all;
    if (p > 0u) barrier();
    uint place = groupPlaceFor(counts[p], all);
    at[2u * p] = before + (place & 0xffffu);
    ends[2u * p] = before + (all & 0xffffu);
    at[2u * p + 1u] = ends[2u * p] + (place >> 16u);
    ends[2u * p + 1u] = ends[2u * p] + (all >> 16u);
    before = ends[2u * p + 1u];
  }
  for (uint e = 0u; e < mine; ++e) {
    uint k = begin + e * invocationsOfTile;
    uint its = 2u * (pairs >> 2u * e & 3u) + (halves >> e & 1u);
    uint node = lists[list + 1u + k] & ~openedBit;
    uint put = 0u;
    [[unroll]] for (uint t = 0u; t < kindsOfEntries; ++t) {
      put += t == its ? at[t] : 0u;
      at[t] += t == its ? 1u : 0u;
    }
    sorted[put] = node;
  }
  barrier();
}

#endif
