// The sky's light that enters each surfel, by how much of it the clusters around see. A work group has some of
// the surfels of a cluster.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#define BINDING_CLUSTER_NODES 2
#define BINDING_SKY_IRRADIANCE 3
#include "lib/boundary.glsl"
#include "lib/cluster_node.glsl"
#include "lib/cluster_weight.glsl"
#include "lib/sky.glsl"
#include "lib/source_flux.glsl"
#include "lib/texels.glsl"
#include "lib/work_group.glsl"
#include "shared/surfels.h"

layout(std430, set = 0, binding = 4) readonly buffer Ranges { ClusterRange ranges[]; };
TEXELS(5, clusterTexels);  // Cluster
TEXELS(6, skyShares);  // of clusters
layout(std430, set = 0, binding = 7) readonly buffer SurfelNormals { vec4 surfelNormals[]; };
layout(std430, set = 0, binding = 8) readonly buffer SurfelPlaces { vec4 places[]; };
layout(std430, set = 0, binding = 9) buffer Sources { Source sources[]; };
layout(std430, set = 0, binding = 11) readonly buffer Around { uint around[]; };
layout(std430, set = 0, binding = 10) writeonly buffer SharesOfSurfels { vec4 sharesOfSurfels[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
};

// What tells how much a cluster counts at a place.
struct Felt {
  bool near;
  vec4 place;       // w: 1 over its reach squared
  vec4 normalPeak;
  vec3 share;
};

// The cluster around that has that leaf, for places within a radius of a middle.
Felt feltOf(uint leaf, vec3 middle, float radius) {
  vec4 centroidLink = centroidLinkOf(leaf);
  float reach = spreadOf(leaf).z;
  int cluster = int(firstSurfelOf(floatBitsToUint(centroidLink.w)));
  vec4 normalRadius = texelOf(clusterTexels, texelOfCluster(uint(cluster), 1u));
  vec4 shareLight = texelOf(skyShares, cluster);
  Felt its;
  its.near = distance(centroidLink.xyz, middle) <= reach + radius;
  its.place = vec4(centroidLink.xyz, 1.0 / max(reach * reach, 1e-30));
  // Few rays say nothing of a bright part that they miss.
  its.normalPeak = vec4(normalRadius.xyz, shareLight.w * peakOfCluster(reach, edgeOfDisc(normalRadius.w)));
  its.share = shareLight.rgb;
  return its;
}

// The invocations of a subgroup go in step: each reads one of the clusters around and passes it to the others.
vec3 shareAt(vec3 place, vec3 normal, uint cluster, ClusterRange range) {
  vec3 middle = centroidLinkOf(range.node).xyz;
  float radius = spreadOf(range.node).x;
  vec3 sum = vec3(0.0);
  float all = 0.0;
  uint list = range.tile * roomOfAround;
  uint end = list + 1u + around[list];
  uint width = min(gl_SubgroupSize, gl_WorkGroupSize.x);
  for (uint first = list + 1u; first < end; first += width) {
    uint at = first + gl_SubgroupInvocationID;
    Felt its = feltOf(around[min(at, end - 1u)], middle, radius);
    for (uvec4 left = subgroupBallot(its.near && at < end); any(notEqual(left.xy, uvec2(0u)));) {
      uint k = subgroupBallotFindLSB(left);
      left[k / 32u] &= left[k / 32u] - 1u;
      vec4 itsPlace = subgroupBroadcast(its.place, k);
      vec4 normalPeak = subgroupBroadcast(its.normalPeak, k);
      vec3 offset = itsPlace.xyz - place;
      float weight = normalPeak.w * fallOfCluster(dot(offset, offset) * itsPlace.w, dot(normal, normalPeak.xyz));
      sum += weight * subgroupBroadcast(its.share, k);
      all += weight;
    }
  }
  return all > 0.0 ? sum / all : texelOf(skyShares, int(cluster)).rgb;
}

void main() {
  uint cluster = groupIndex() % clusterCount;
  uint part = groupIndex() / clusterCount;
  ClusterRange range = ranges[cluster];
  if (range.side < 0.0) return;  // surfels belong to the front
  ObjectData body = objects[range.object];
  uint begin = range.firstSurfel + part * surfelsOfPart;
  uint end = min(begin + surfelsOfPart, range.endSurfel);
  for (uint first = begin; first < end; first += gl_WorkGroupSize.x) {
    uint surfel = first + gl_LocalInvocationIndex;
    bool inside = surfel < end;
    vec3 place = places[inside ? surfel : first].xyz;
    vec3 normal = surfelNormals[inside ? surfel : first].xyz;
    vec3 share = shareAt(place, normal, cluster, range);
    if (!inside) continue;
    vec3 irradiance = skyIrradianceAt(normal, mediumAt(body, place)) * share;
    sharesOfSurfels[surfel] = vec4(share, 0.0);
    for (uint s = sourcesPerSurfel * surfel; s < sourcesPerSurfel * (surfel + 1u); ++s)
      sources[s].flux.rgb += fluxThrough(sources[s].positionArea.w, irradiance);
  }
}
