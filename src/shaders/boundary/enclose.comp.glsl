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

// For the node found last.
bool isFelt(uint node) {
  return leastSigma * (sqrt(nearestOnWalk) - spreadOf(node).x) < furthestFelt;
}

// What an invocation finds is kept, in 8 KiB for all of the group, until its place on the list is known. Nodes for which
// there is no room are looked for again.
const uint roomOfFound = 2048u / invocationsOfTile;
shared uint found[roomOfFound * invocationsOfTile];

uint placeOfFound(uint k) {
  return gl_LocalInvocationIndex * roomOfFound + k;
}

// A walk of an invocation.
struct Walk {
  uint at;      // the next node
  uint count;   // of nodes found
  uint resume;  // the next node where the first one was found that is not kept
};

Walk walkOfTile() {
  return Walk(body.clusters.x, 0u, 0u);
}

void keep(uint node, uint before, inout Walk walk) {
  if (walk.count < roomOfFound) found[placeOfFound(walk.count)] = node;
  if (walk.count == roomOfFound) walk.resume = before;
  ++walk.count;
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
  Walk walk = walkOfTile();
  while (true) {
    uint before = walk.at;
    uint node = nextFelt(walk.at, radius);
    if (node == noNode) break;
    keep(node, before, walk);
  }
  uint all;
  uint place = groupPlaceFor(walk.count, all);
  uint list = tileIndex * roomOfAround;
  uint room = roomOfAround - 1u;
  if (gl_LocalInvocationIndex == 0u) around[list] = min(all, room);
  uint count = min(walk.count, room - min(place, room));
  place += list + 1u;
  for (uint k = 0u; k < min(count, roomOfFound); ++k) around[place + k] = found[placeOfFound(k)];
  for (uint k = roomOfFound; k < count; ++k) around[place + k] = nextFelt(walk.resume, radius);
  barrier();
}

// Lists the nodes that act on the tile and are felt there, of the walk that found them.
void listActing(Walk walk) {
  uint all;
  uint place = groupPlaceFor(walk.count, all);
  uint list = tileIndex * roomOfList;
  if (gl_LocalInvocationIndex == 0u) lists[list] = all;
  uint count = all < roomOfList ? walk.count : 0u;
  place += list + 1u;
  for (uint k = 0u; k < min(count, roomOfFound); ++k) lists[place + k] = found[placeOfFound(k)];
  for (uint k = roomOfFound; k < count;) {
    uint node = nextOnWalk(walk.resume, openingAngle);
    if (node == noNode) break;
    if (isFelt(node)) lists[place + k++] = node;
  }
}

void main() {
  if (!enterTile(tileCount)) return;
  listAround();
  float shares[maxClustersOfTile];
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) shares[t] = 0.0;
  Walk walk = walkOfTile();
  while (true) {
    uint before = walk.at;
    uint node = nextOnWalk(walk.at, openingAngle);
    if (node == noNode) break;
    if (isFelt(node)) keep(node, before, walk);
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
  listActing(walk);

  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) addToTile(t, vec3(shares[t]));
  uint target = gl_LocalInvocationIndex;
  vec3 sum = sumOfTile(target);
  if (target < tile.endCluster - tile.firstCluster)
    clusters[tile.firstCluster + target].vectorArea.w = sum.x / (4.0 * pi);
}
