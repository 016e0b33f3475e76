// The fluence that points of light would give every cluster in a medium without end:
// φˢ_i = Σ power e^{-σr} / 4πDr, r² = |x_i - y|² + ρ_i²/4.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "lib/linear.glsl"
#include "lib/beam_walk.glsl"

// e^{-σr} / r of light that entered through a disc of that area.
vec3 kernel(vec3 squared, float areaMm2) {
  vec3 away = sqrt(squared + smoothingOf(its.centroidArea.w, areaMm2));
  return exp(-medium.sigma.rgb * away) / away;
}

// How much more points give than if all were at their centroid, to second order: ½ Q:∇∇G / G of the
// kernel G, with their mean squares Q. Of that σ² tr Q/6 is as all directions are alike, but for what
// the power has of it; the rest is ½ (r̂ᵀQr̂ - tr Q/3) (σ² + 3σ/r + 3/r²).
vec3 withSpread(BeamNode node, mat3 offsets, vec3 squared) {
  vec3 sigma = medium.sigma.rgb;
  mat3 square = mat3(node.square.x, node.across.xy, node.across.x, node.square.y, node.across.z,
                     node.across.yz, node.square.z);
  vec3 over = 1.0 / squared;
  vec3 along;
  for (int c = 0; c < 3; ++c) along[c] = over[c] * dot(offsets[c], square * offsets[c]);
  float third = (node.square.x + node.square.y + node.square.z) / 3.0;
  vec3 curvature = sigma * sigma + 3.0 * sigma * sqrt(over) + 3.0 * over;
  return 1.0 + sigma * sigma * (node.blueSquare.w / 6.0) + 0.5 * (along - third) * curvature;
}

vec3 fromNode(BeamNode node, vec3 squared) {
  vec3 place = its.centroidArea.xyz;
  mat3 offsets = mat3(node.redRadius.xyz - place, node.greenLink.xyz - place,
                      node.blueSquare.xyz - place);
  return node.power.rgb * kernel(squared, 0.0) * withSpread(node, offsets, squared);
}

// The cluster's own light, of first collisions on the way in, as from discs at their depths:
// (e^{-σz} - e^{-σ√(z² + ρ²)}) / 2Dσ, here times 4πD.
vec3 fromDisc(BeamPoint point) {
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

vec3 ownDiscs() {
  vec4 strength = strengths[receiver];
  uint count = min(unpackPointCounts(strength.w).x, pointsOfFirstSegment);
  vec3 sum = vec3(0.0);
  for (uint p = 0u; p < count; ++p) {
    BeamPoint point = readPoint(receiver * maxPoints + p);
    sum += shareOf(point) * fromDisc(point);
  }
  return strength.rgb * shareOfFirst(its) * sum;
}

vec3 fromPoints(uint cluster) {
  vec4 strength = strengths[cluster];
  uvec2 counts = unpackPointCounts(strength.w);
  vec3 place = its.centroidArea.xyz;
  vec3 first = vec3(0.0);
  uint at = cluster * maxPoints;
  Cluster from = clusters[cluster];
  uint firstCount = shareOfFirst(from) == vec3(0.0) ? 0u : counts.x;
  for (uint p = cluster == receiver ? pointsOfFirstSegment : 0u; p < firstCount; ++p) {
    BeamPoint point = readPoint(at + p);
    first += shareOf(point) * kernel(squaredDistances(point, place), from.centroidArea.w);
  }
  vec3 second = vec3(0.0);
  for (uint p = 0u; p < counts.y; ++p) {
    BeamPoint point = readPoint(at + maxFirstPoints + p);
    second += shareOf(point) * kernel(squaredDistances(point, place), from.centroidArea.w);
  }
  return strength.rgb * (shareOfFirst(from) * first + shareOfSecond(from, medium) * second);
}

void main() {
  receive();
  vec3 sum = beamSum(leastOf(medium.sigma.rgb), 1e18);
  if (hasOwnLeaf()) sum += ownDiscs();
  putSum(sum / (4.0 * pi * medium.diffusion.rgb));
}
