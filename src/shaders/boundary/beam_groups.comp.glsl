// The nodes of light that act on the clusters of a group: leaves, and nodes that are far from all of the
// clusters. Lists them for each tree that boundary/beam_nodes.comp.glsl has made.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define TILE_WORK
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_BEAM_NODES 2
#include "lib/boundary.glsl"
#include "lib/beam_node.glsl"
#include "lib/beam_trees.glsl"
#include "lib/group_place.glsl"
#include "lib/texels.glsl"
#include "lib/work_group.glsl"

layout(std430, set = 0, binding = 3) readonly buffer Groups { ClusterGroup groups[]; };
TEXELS(4, clusterTexels);  // Cluster
layout(std430, set = 0, binding = 5) writeonly buffer Lists { uint lists[]; };

layout(push_constant) uniform Push {
  uint groupCount;
  float openingAngle;
  uint firstTree;
  uint trees;
  uint kinds;  // of trees
  uint lights;
  uint nodeCount;  // of a tree
  uint room;       // of a list
  uint firstNode;  // of the nodes of each body
  uint endNode;
};

// Light that scatters once is gone beyond this.
const float furthestFreePaths = 8.0;

uint root;  // of the tree
ClusterGroup group;
Around around;
float sigma;
float reachMm;  // no light of any point comes from further

// The part of the body's nodes that this invocation looks at.
uint sliceBegin;
uint sliceEnd;

vec3 placeOf(uint cluster) {
  return texelOf(clusterTexels, texelOfCluster(cluster, 0u)).xyz;
}

Around aroundGroup() {
  vec3 low = placeOf(group.firstCluster);
  vec3 high = low;
  for (uint i = group.firstCluster + 1u; i < group.endCluster; ++i) {
    low = min(low, placeOf(i));
    high = max(high, placeOf(i));
  }
  vec3 middle = 0.5 * (low + high);
  float radius = 0.0;
  for (uint i = group.firstCluster; i < group.endCluster; ++i) radius = max(radius, distance(placeOf(i), middle));
  return Around(middle, radius);
}

// The group's own leaves are always opened.
bool isFarFromAll(BeamNode node) {
  uint cluster = clusterOf(node);
  bool own = isLeaf(linkOf(node)) && cluster >= group.firstCluster && cluster < group.endCluster;
  float nearest = nearestOf(node, around);
  return !own && isFar(nearest * nearest, node.extent.x, sigma, openingAngle);
}

// The next entry for the list, from node `at` on in this invocation's slice, or noNode.
uint nextActing(inout uint at) {
  uint found = noNode;
  while (found == noNode && at < sliceEnd) {
    BeamNode node = readBeamNode(root + at);
    uint link = linkOf(node);
    uint after = afterNode(at, link);
    bool left = node.extent.x < 0.0 || after <= sliceBegin ||
                nearestOf(node, around) > reachMm + 2.0 * node.extent.z;
    bool far = isFarFromAll(node);
    bool taken = far || isLeaf(link);
    if (taken && !left && at >= sliceBegin) found = far ? at : at | openedBit;
    at = left || taken ? after : at + 1u;
  }
  return found;
}

void main() {
  uint index = groupIndex();
  if (index / groupCount >= trees) return;
  uint tree = firstTree + index / groupCount;
  bool scattersOnce = beamTree(tree, kinds, lights).scattersOnce;
  root = tree * nodeCount;
  group = groups[index % groupCount];
  ObjectData body = objects[group.object];
  BoundaryMedium medium = insideOf(body);
  around = aroundGroup();
  sigma = scattersOnce ? 0.0 : leastOf(medium.sigma.rgb);
  reachMm = scattersOnce ? furthestFreePaths / leastOf(medium.collision.rgb) : 1e18;
  uint begin = min(body.clusters.x + firstNode, body.clusters.y);
  uint nodes = min(body.clusters.x + endNode, body.clusters.y) - begin;
  uint i = gl_LocalInvocationIndex;
  sliceBegin = begin + nodes * i / gl_WorkGroupSize.x;
  sliceEnd = begin + nodes * (i + 1u) / gl_WorkGroupSize.x;

  uint count = 0u;
  uint at = body.clusters.x;
  while (nextActing(at) != noNode) ++count;
  uint all;
  uint list = startOfList(firstTree * groupCount + index, room);
  uint place = list + 1u + groupPlaceFor(count, all);
  if (i == 0u) lists[list] = all;
  at = body.clusters.x;
  for (uint entry = nextActing(at); entry != noNode; entry = nextActing(at)) lists[place++] = entry;
}
