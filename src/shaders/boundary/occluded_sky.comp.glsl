// The sky's light that enters each surfel: as much of it as the clusters around see. A work group has a
// cluster. Its invocations find the clusters that are felt there, and then have a surfel each.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define LONG_WORK
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_CLUSTER_NODES 2
#define BINDING_SKY_IRRADIANCE 3
#include "lib/boundary.glsl"
#include "lib/cluster_node.glsl"
#include "lib/cluster_weight.glsl"
#include "lib/group_place.glsl"
#include "lib/sky.glsl"
#include "lib/source_flux.glsl"
#include "lib/work_group.glsl"
#include "shared/surfels.h"

layout(std430, set = 0, binding = 4) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 5) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 6) readonly buffer SkyShares { vec4 skyShares[]; };
layout(std430, set = 0, binding = 7) readonly buffer SurfelNormals { vec4 surfelNormals[]; };
layout(std430, set = 0, binding = 8) readonly buffer SurfelPlaces { vec4 places[]; };
layout(std430, set = 0, binding = 9) buffer Sources { Source sources[]; };
layout(std430, set = 0, binding = 10) writeonly buffer SharesOfSurfels { vec4 sharesOfSurfels[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
};

// Where more are felt, those that come last in the tree are not.
const uint mostFelt = 128u;
struct Felt {
  vec4 placeReach;
  vec4 normalEdge;
  vec4 share;
};
shared Felt felt[mostFelt];

uint sliceBegin;
uint sliceEnd;

// Of this invocation's part of the tree, the next leaf from `at` on that is felt within `radius`.
uint nextFelt(inout uint at, vec3 place, float radius) {
  while (at < sliceEnd) {
    uint node = at;
    vec4 centroidLink = centroidLinkOf(node);
    uint link = floatBitsToUint(centroidLink.w);
    uint after = afterNode(node, link);
    bool apart = after <= sliceBegin ||
                 distance(centroidLink.xyz, place) > spreadOf(node).z + radius;
    at = apart || isLeaf(link) ? after : node + 1u;
    if (!apart && isLeaf(link) && node >= sliceBegin) return firstSurfelOf(link);
  }
  return noCluster;
}

void putFelt(uint at, uint cluster) {
  Cluster its = clusters[cluster];
  felt[at] = Felt(vec4(its.centroidArea.xyz, spreadOf(ranges[cluster].node).z),
                  vec4(its.normal.xyz, edgeOf(its)), skyShares[cluster]);
}

uint findFelt(ObjectData body, vec3 place, float radius) {
  uint nodes = body.clusters.y - body.clusters.x;
  uint i = gl_LocalInvocationIndex;
  sliceBegin = body.clusters.x + nodes * i / gl_WorkGroupSize.x;
  sliceEnd = body.clusters.x + nodes * (i + 1u) / gl_WorkGroupSize.x;
  uint count = 0u;
  uint at = body.clusters.x;
  while (nextFelt(at, place, radius) != noCluster) ++count;
  uint all;
  uint next = groupPlaceFor(count, all);
  at = body.clusters.x;
  for (; count > 0u && next < mostFelt; --count) putFelt(next++, nextFelt(at, place, radius));
  barrier();
  return min(all, mostFelt);
}

vec3 shareAt(vec3 place, vec3 normal, uint count, uint own) {
  vec3 sum = vec3(0.0);
  float all = 0.0;
  for (uint k = 0u; k < count; ++k) {
    vec3 offset = felt[k].placeReach.xyz - place;
    float weight = weightOfCluster(dot(offset, offset), felt[k].placeReach.w, felt[k].normalEdge.w,
                                   dot(normal, felt[k].normalEdge.xyz));
    // Few rays tell nothing of a bright part that they miss.
    weight *= felt[k].share.w;
    sum += weight * felt[k].share.rgb;
    all += weight;
  }
  return all > 0.0 ? sum / all : skyShares[own].rgb;
}

void main() {
  uint cluster = groupIndex();
  if (cluster >= clusterCount) return;
  ClusterRange range = ranges[cluster];
  if (range.side < 0.0) return;  // surfels are of the front
  ObjectData body = objects[range.object];
  uint count = findFelt(body, clusters[cluster].centroidArea.xyz, spreadOf(range.node).x);
  for (uint surfel = range.firstSurfel + gl_LocalInvocationIndex; surfel < range.endSurfel;
       surfel += gl_WorkGroupSize.x) {
    vec3 place = places[surfel].xyz;
    vec3 normal = surfelNormals[surfel].xyz;
    vec3 share = shareAt(place, normal, count, cluster);
    vec3 irradiance = skyIrradianceAt(normal, mediumAt(body, place)) * share;
    sharesOfSurfels[surfel] = vec4(share, 0.0);
    for (uint s = sourcesPerSurfel * surfel; s < sourcesPerSurfel * (surfel + 1u); ++s)
      sources[s].flux.rgb += fluxThrough(sources[s].positionArea.w, irradiance);
  }
}
