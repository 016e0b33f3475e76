// The fluence that points of light would give every cluster in an infinite medium: φˢ_i = Σ power
// e^{-σr} / 4πDr, r² = |x_i - y|² + ρ_i²/4.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define CONSTANT_SEVERAL_MEDIA 0
#include "lib/beam_sum.glsl"
#include "lib/fluence_points.glsl"

// The cluster's own light, of first collisions on the way in, as from discs at their depths:
// (e^{-σz} - e^{-σ√(z² + ρ²)}) / 2Dσ, here times 4πD.
vec3 fromDisc(Cluster its, BeamPoint point) {
  vec3 place = its.centroidArea.xyz;
  vec3 depth = -vec3(dot(point.red.xyz - place, its.normal.xyz),
                     dot(point.green.xyz - place, its.normal.xyz),
                     dot(point.blue.xyz - place, its.normal.xyz));
  depth = max(depth, 0.0);
  vec3 sigma = medium.sigma.rgb;
  float radius = its.normal.w;
  vec3 further = sqrt(depth * depth + radius * radius) - depth;
  return 2.0 * pi / max(its.centroidArea.w, 1e-30) * exp(-sigma * depth) *
         absorbedLength(sigma, further);
}

vec3 ownDiscs(uint receiver) {
  Cluster its = clusters[receiver];
  uint beam = beamOf(receiver);
  vec4 strength = strengthOf(beam);
  uint count = min(unpackPointCounts(strength.w).x, pointsOfFirstSegment);
  vec3 sum = vec3(0.0);
  for (uint p = 0u; p < count; ++p) {
    BeamPoint point = readPoint(beam, p);
    sum += shareOf(point) * fromDisc(its, point);
  }
  return strength.rgb * shareOfFirst(its) * sum;
}

void expandNode(uint index, vec3 middle) {
  takeWayFrom(index);
  BeamNode node = readLit(index);
  expandNodeOf(node, powerOf(node), middle);
}

void addNode(uint index) {
  takeWayFrom(index);
  BeamNode node = readLit(index);
  addNodeOf(node, powerOf(node));
}

Sender senderAt(uint node) {
  takeWayFrom(node);
  uint cluster = clusterOf(readListed(node));
  return senderOf(cluster, strengthOf(beamOf(cluster)).rgb);
}

void sumList(Around around) {
  if (!isLit()) return;
  uint list = startOfTilesList();
  uint count = lists[list];
  for (uint begin = sumKept(around.middle); begin < count; begin += sizeOfPart) {
    sortPart(list, begin, min(begin + sizeOfPart, count), around, leastSigma);
    uint i = gl_LocalInvocationIndex;
    for (uint k = i; k < ends[0]; k += invocationsOfTile) addNode(sorted[k]);
    for (uint k = ends[0] + i; k < ends[1]; k += invocationsOfTile)
      expandNode(sorted[k], around.middle);
    for (uint k = ends[1] + i; k < ends[2]; k += invocationsOfTile) addPoints(senderAt(sorted[k]));
    for (uint k = ends[2] + i; k < ends[3]; k += invocationsOfTile)
      expandPoints(senderAt(sorted[k]), around.middle);
    barrier();
  }
}

void main() {
  if (!enterTile(tileCount)) return;
  Around around = aroundTile();
  takeWayOfTile();
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) tileLight[t] = vec3(0.0);
  [[unroll]] for (uint t = 0u; t < termsOfExpansion; ++t) expansion[t] = vec3(0.0);
  for (light = 0u; light < lights; ++light) sumList(around);
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) addToTile(t, tileLight[t] + expandedAt(targets[t].xyz - around.middle));
  uint target = gl_LocalInvocationIndex;
  vec3 sum = sumOfTile(target);
  if (target >= tile.endCluster - tile.firstCluster) return;
  vec3 own = vec3(0.0);
  for (light = 0u; light < lights; ++light) own += ownDiscs(tile.firstCluster + target);
  putLight(target, sum, own, 1.0 / (4.0 * pi * medium.diffusion.rgb));
}
