// Light that scattered once and leaves after it was mirrored inside, brought to the clusters through which it leaves.
// It is first added up in whole numbers, then turned into exitance. A way stands for all in directions near it, so
// what it brings is spread over the clusters around. Then nothing jumps where ways move on to other clusters.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_CLUSTER_NODES 0
#define BINDING_RANGES 1
#define BINDING_CLUSTERS 2
#define BINDING_AROUND 3
#include "lib/around_cluster.glsl"
#include "lib/linear.glsl"
#include "lib/point_counts.glsl"
#include "lib/whole_sums.glsl"

layout(constant_id = 0) const uint addsUp = 1u;

layout(std430, set = 0, binding = 4) readonly buffer Strengths { vec4 strengths[]; };
layout(std430, set = 0, binding = 5) readonly buffer Strongest { uint strongest[]; };
layout(std430, set = 0, binding = 6) readonly buffer GuidedLight { Guided guided[]; };
layout(std430, set = 0, binding = 7) buffer Sums { uint sums[]; };  // three per cluster, of lights, then of everywhere
layout(std430, set = 0, binding = 8) buffer Latest { vec4 latest[]; };  // M₁
layout(std430, set = 0, binding = 9) readonly buffer StrongestOfEverywhere { uint strongestOfEverywhere[]; };
layout(std430, set = 0, binding = 10) readonly buffer StrengthsOfEverywhere { vec4 strengthsOfEverywhere[]; };
layout(std430, set = 0, binding = 11) readonly buffer GuidedOfEverywhere { Guided guidedOfEverywhere[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint lights;          // that were found together
  uint withEverywhere;  // 1: light from everywhere is added up after theirs
};

// The power that 1 of the sums stands for.
float powerOfOne(uint everywhere) {
  uint most = everywhere != 0u ? strongestOfEverywhere[0] : strongest[0];
  return uintBitsToFloat(most) / wholeOfMost(everywhere != 0u ? clusterCount : lights * clusterCount);
}

vec3 sumsOf(uint everywhere, uint i) {
  uint first = 3u * (everywhere * clusterCount + i);
  return vec3(sums[first], sums[first + 1u], sums[first + 2u]);
}

float ones[2];  // powerOfOne() of lights and of everywhere

// What leaves there.
vec3 powerOf(uint cluster) {
  return ones[0] * sumsOf(0u, cluster) + ones[1] * sumsOf(1u, cluster);
}

void main() {
  uint i = linearIndex();
  if (addsUp == 0u) {
    ones = float[2](powerOfOne(0u), powerOfOne(1u));
    if (i < clusterCount && boundsDiffusion(ranges[i].kind)) latest[i].rgb += meanAround(i);
    return;
  }
  uint ofLights = lights * clusterCount * pathsOfBeam;
  uint everywhere = i >= ofLights ? 1u : 0u;
  if (i >= ofLights + withEverywhere * clusterCount * pathsOfBeam) return;
  float one = powerOfOne(everywhere);
  if (one <= 0.0) return;
  uint way = i - everywhere * ofLights;
  uint path = way % pathsOfBeam;
  vec4 strength = everywhere != 0u ? strengthsOfEverywhere[way / pathsOfBeam] : strengths[way / pathsOfBeam];
  if (path >= 3u * unpackPointCounts(strength.w).y) return;
  Guided its;
  if (everywhere != 0u)
    its = guidedOfEverywhere[way];
  else
    its = guided[way];
  uint parts = uint(strength[path % 3u] * its.share / one + 0.5);
  if (parts > 0u) atomicAdd(sums[3u * (everywhere * clusterCount + its.cluster) + path % 3u], parts);
}
