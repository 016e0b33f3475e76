// The next vector of the solver's basis, from the last product, and its densities on the nodes, taken as a
// fluence at the clusters; or the densities of the fluence at which as much leaves as has entered. Each node
// takes them from the clusters below it, so that none waits for another. A work group has some leaves and
// nodes of few clusters, or one of many.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define TILE_WORK
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_CLUSTER_NODES 2
#define BINDING_CLUSTER_PAINTS 11
#define BINDING_OPAQUE_SHARES 12
#define LININGS
#include "lib/boundary.glsl"
#include "lib/cluster_node.glsl"
#include "lib/over_or_0.glsl"
#include "lib/painted_cluster.glsl"
#include "lib/texels.glsl"
#include "lib/work_group.glsl"

layout(std430, set = 0, binding = 3) readonly buffer Inner { InnerNode innerNodes[]; };
layout(std430, set = 0, binding = 4) readonly buffer Ranges { ClusterRange ranges[]; };

ClusterRange rangeOf(uint cluster) {
  return ranges[cluster];
}

TEXELS(5, clusterTexels);  // Cluster
TEXELS(6, products);
layout(std430, set = 0, binding = 7) buffer Basis { vec4 basis[]; };
layout(std430, set = 0, binding = 8) buffer Nodes { DensityNode nodes[]; };  // for each vector of the basis
layout(std430, set = 0, binding = 9) readonly buffer States { SolverState states[]; };
layout(std430, set = 0, binding = 10) readonly buffer Entered { vec4 entered[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint smallCount;  // of inner nodes, those of few clusters
  uint innerCount;
  uint nodeCount;
  uint solution;
  uint ofEntered;  // 1: takes the light that has entered at the surface, for its double layer alone
};

vec3 enteredFluence(uint cluster) {
  float thicknessMm = texelOf(clusterTexels, texelOfCluster(cluster, 3u)).w;
  BoundaryMedium medium = insideOf(objects[ranges[cluster].object]);
  return fluenceEntered(cluster, entered[cluster].rgb, thicknessMm, medium);
}

// The basis has as many vectors as there were steps.
uint vectorCount() {
  return ofEntered != 0u ? 0u : states[solution].steps;
}

// What is left of the last product without its parts along the basis so far, over its norm.
vec3 nextVector(uint cluster) {
  vec3 vector = texelOf(products, int(cluster)).rgb;
  uint steps = vectorCount();
  for (uint k = 0u; k < steps; ++k)
    vector -= states[solution].projections[k].rgb * basis[k * clusterCount + cluster].rgb;
  return overOr0(vector, states[solution].projections[steps].rgb);
}

DensityNode noDensity() {
  return DensityNode(vec4(0.0), vec4(0.0), vec4(0.0));
}

// Seen from `place`, a density is one there plus a dipole.
void add(inout DensityNode sum, uint cluster, vec3 fluence, vec3 place, vec3 weightS) {
  vec4 centroidArea = texelOf(clusterTexels, texelOfCluster(cluster, 0u));
  vec3 vectorArea = texelOf(clusterTexels, texelOfCluster(cluster, 2u)).xyz;
  vec3 escape = texelOf(clusterTexels, texelOfCluster(cluster, 7u)).rgb;
  vec3 areas = centroidArea.w * layerOf(cluster) * escape;
  vec3 arm = centroidArea.xyz - place;
  sum.red += fluence.r * vec4(vectorArea + weightS.r * areas.r * arm, areas.r);
  sum.green += fluence.g * vec4(vectorArea + weightS.g * areas.g * arm, areas.g);
  sum.blue += fluence.b * vec4(vectorArea + weightS.b * areas.b * arm, areas.b);
}

// The density of the last product, or of what has entered, at the clusters below: every `stride`-th from the
// `start`-th on.
DensityNode densityOf(InnerNode inner, uint start, uint stride) {
  vec3 weightS = ofEntered != 0u ? vec3(0.0) : singleLayerWeight(insideOf(objects[inner.object]));
  vec3 place = centroidLinkOf(inner.node).xyz;
  DensityNode sum = noDensity();
  for (uint i = inner.firstCluster + start; i < inner.endCluster; i += stride)
    add(sum, i, ofEntered != 0u ? enteredFluence(i) : texelOf(products, int(i)).rgb, place, weightS);
  return sum;
}

// Combines the last product's density with those of the vectors so far, as the next vector does with the vectors.
void putInner(uint node, DensityNode sum) {
  uint steps = vectorCount();
  for (uint k = 0u; k < steps; ++k) {
    vec3 projection = states[solution].projections[k].rgb;
    DensityNode before = nodes[k * nodeCount + node];
    sum.red -= projection.r * before.red;
    sum.green -= projection.g * before.green;
    sum.blue -= projection.b * before.blue;
  }
  vec3 scale = ofEntered != 0u ? vec3(1.0) : overOr0(vec3(1.0), states[solution].projections[steps].rgb);
  nodes[steps * nodeCount + node] = DensityNode(scale.r * sum.red, scale.g * sum.green, scale.b * sum.blue);
}

shared DensityNode ofSubgroup[gl_WorkGroupSize.x / 4u];  // for subgroups of at least 4

void putLarge(InnerNode inner) {
  DensityNode sum = densityOf(inner, gl_LocalInvocationIndex, gl_WorkGroupSize.x);
  sum = DensityNode(subgroupAdd(sum.red), subgroupAdd(sum.green), subgroupAdd(sum.blue));
  if (subgroupElect()) ofSubgroup[gl_SubgroupID] = sum;
  barrier();
  if (gl_LocalInvocationIndex != 0u) return;
  for (uint g = 1u; g < gl_NumSubgroups; ++g) {
    sum.red += ofSubgroup[g].red;
    sum.green += ofSubgroup[g].green;
    sum.blue += ofSubgroup[g].blue;
  }
  putInner(inner.node, sum);
}

void putLeaf(uint cluster) {
  vec3 fluence = ofEntered != 0u ? enteredFluence(cluster) : nextVector(cluster);
  if (ofEntered == 0u) basis[vectorCount() * clusterCount + cluster] = vec4(fluence, 0.0);
  DensityNode sum = noDensity();
  add(sum, cluster, fluence, vec3(0.0), vec3(0.0));
  nodes[vectorCount() * nodeCount + ranges[cluster].node] = sum;
}

void putSmall(InnerNode inner) {
  putInner(inner.node, densityOf(inner, 0u, 1u));
}

void main() {
  uint alone = clusterCount + smallCount;
  uint groupsAlone = groupsOfNodes(alone);
  if (groupIndex() >= groupsAlone) {
    uint large = smallCount + groupIndex() - groupsAlone;
    if (large < innerCount) putLarge(innerNodes[large]);
    return;
  }
  uint first = groupIndex() * nodesOfGroup;
  uint end = min(first + nodesOfGroup, alone);
  for (uint i = first + gl_LocalInvocationIndex; i < end; i += gl_WorkGroupSize.x) {
    if (i < clusterCount) putLeaf(i);
    else putSmall(innerNodes[i - clusterCount]);
  }
}
