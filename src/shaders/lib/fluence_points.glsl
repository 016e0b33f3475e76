// The fluence that a cluster's points of light would give the clusters of a tile in an infinite medium, times 4πD.
#ifndef OPALINE_LIB_FLUENCE_POINTS
#define OPALINE_LIB_FLUENCE_POINTS
#include "lib/beam_tile.glsl"

// A cluster's points.
struct Sender {
  uint cluster;
  uint beam;
  uint firstCount;
  uint count;
  vec3 ofFirst;  // power
  vec3 ofSecond;
  float areaMm2;     // of the disc that the light entered through
  float narrowness;  // see Discs
  vec3 whereWide;
};

// A disc must be small for the part of the body that it lies on. Else the few points that get through stand for so
// much light that clusters beside them would differ.
float narrownessOf(Cluster cluster) {
  return 1.0 - smoothstep(0.3, 0.6, sqrt(cluster.centroidArea.w) / max(cluster.start.w, 1e-30));
}

// The sender of that power.
Sender senderOf(uint cluster, vec3 power) {
  uint beam = beamOf(cluster);
  uvec2 counts = unpackPointCounts(strengthOf(beam).w);
  Cluster from = clusters[cluster];
  vec3 first = shareOfFirst(from);
  uint firstCount = first == vec3(0.0) ? 0u : counts.x;
  return Sender(cluster, beam, firstCount, firstCount + counts.y, power * way.overDiffusion * first,
                power * way.overDiffusion * shareOfSecond(from, medium), from.centroidArea.w,
                narrownessOf(from), lackOfPlane(from.centroidArea.w, 0.5 * from.start.w, way.sigma, medium));
}

BeamPoint pointOf(Sender from, uint p) {
  uint order = p < from.firstCount ? p : p - from.firstCount + maxFirstPoints;
  return readPoint(from.beam, order);
}

vec3 powerOf(Sender from, uint p, BeamPoint point) {
  return shareOf(point) * (p < from.firstCount ? from.ofFirst : from.ofSecond);
}

const uint termsOfExpansion = 11u;

// Light from where the tile looks small, expanded about its middle to second order. The terms of
// each channel: 1; x, y, z; xx + yy + zz; xx, yy, zz; xy, xz, yz.
vec3 expansion[termsOfExpansion];

void expand(BeamPoint point, vec3 power, float smoothing, vec3 middle) {
  vec3 x = middle.x - vec3(point.red.x, point.green.x, point.blue.x);
  vec3 y = middle.y - vec3(point.red.y, point.green.y, point.blue.y);
  vec3 z = middle.z - vec3(point.red.z, point.green.z, point.blue.z);
  vec3 squared = x * x + y * y + z * z + smoothing;
  vec3 sigma = way.sigma;
  vec3 over = inversesqrt(squared);
  vec3 over2 = over * over;
  vec3 away = sigma * (squared * over);
  vec3 value = power * exp(-away) * over;
  vec3 first = value * over2 * (1.0 + away);
  vec3 second = value * (over2 * over2) * (3.0 + away * (3.0 + away));
  expansion[0] += value;
  expansion[1] -= first * x;
  expansion[2] -= first * y;
  expansion[3] -= first * z;
  expansion[4] -= first;
  expansion[5] += second * x * x;
  expansion[6] += second * y * y;
  expansion[7] += second * z * z;
  expansion[8] += second * x * y;
  expansion[9] += second * x * z;
  expansion[10] += second * y * z;
}

vec3 expandedAt(vec3 d) {
  vec3 squares = 0.5 * d * d;
  return expansion[0] + d.x * expansion[1] + d.y * expansion[2] + d.z * expansion[3] +
         (squares.x + squares.y + squares.z) * expansion[4] + squares.x * expansion[5] +
         squares.y * expansion[6] + squares.z * expansion[7] + d.x * d.y * expansion[8] +
         d.x * d.z * expansion[9] + d.y * d.z * expansion[10];
}

vec3 depthsBelow(uint target, BeamPoint point) {
  vec3 place = targets[target].xyz;
  vec3 normal = targetNormals[target].xyz;
  return vec3(dot(place - point.red.xyz, normal), dot(place - point.green.xyz, normal), dot(place - point.blue.xyz, normal));
}

// Adds to all clusters of the tile but the one that is `without`.
void addPoint(BeamPoint point, vec3 power, Sender from, uint without) {
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) {
    Discs discs = discsBetween(targets[t].w, from.areaMm2, medium);
    discs.narrowness = from.narrowness;
    discs.whereWide = from.whereWide;
    vec3 squared = squaredDistances(point, targets[t].xyz);
    vec3 light = power * kernelBetween(discs, way.sigma, squared, depthsBelow(t, point));
    if (t != without) tileLight[t] += light;
  }
}

// How much more points give than if all were at their centroid, to second order: ½ Q:∇∇G / G for the
// kernel G and their mean squares Q. The part of it that is alike in all directions is σ² tr Q/6,
// less what the power includes; the rest is ½ (r̂ᵀQr̂ - tr Q/3) (σ² + 3σ/r + 3/r²).
vec3 withSpread(BeamNode node, vec3 place) {
  vec3 sigma = way.sigma;
  mat3 square = mat3(node.square.x, node.across.xy, node.across.x, node.square.y, node.across.z,
                     node.across.yz, node.square.z);
  mat3 offsets = mat3(node.redPower.xyz - place, node.greenLink.xyz - place, node.bluePower.xyz - place);
  vec3 along;
  vec3 over;
  for (int c = 0; c < 3; ++c) {
    over[c] = 1.0 / max(dot(offsets[c], offsets[c]), leastSquaredMm2);
    along[c] = over[c] * dot(offsets[c], square * offsets[c]);
  }
  float third = (node.square.x + node.square.y + node.square.z) / 3.0;
  vec3 curvature = sigma * sigma + 3.0 * sigma * sqrt(over) + 3.0 * over;
  return 1.0 + sigma * sigma * (node.square.w / 6.0) + 0.5 * (along - third) * curvature;
}

BeamPoint middlesOf(BeamNode node) {
  return BeamPoint(node.redPower, node.greenLink, node.bluePower);
}

void expandNodeOf(BeamNode node, vec3 power, vec3 middle) {
  expand(middlesOf(node), power * way.overDiffusion * withSpread(node, middle), 0.0, middle);
}

void addNodeOf(BeamNode node, vec3 power) {
  [[unroll]] for (uint t = 0u; t < maxClustersOfTile; ++t) {
    vec3 squared = squaredDistances(middlesOf(node), targets[t].xyz);
    tileLight[t] += power * way.overDiffusion * withSpread(node, targets[t].xyz) *
                    kernel(squared + smoothingOf(targets[t].w, 0.0));
  }
}

void addPoints(Sender from) {
  for (uint p = 0u; p < from.count; ++p) {
    BeamPoint point = pointOf(from, p);
    bool isDisc = p < min(from.firstCount, pointsOfFirstSegment);
    addPoint(point, powerOf(from, p, point), from, isDisc ? from.cluster - tile.firstCluster : noNode);
  }
}

void expandPoints(Sender from, vec3 middle) {
  float smoothing = smoothingOf(targets[0].w, from.areaMm2);
  for (uint p = 0u; p < from.count; ++p) {
    BeamPoint point = pointOf(from, p);
    expand(point, powerOf(from, p, point), smoothing, middle);
  }
}

#endif
