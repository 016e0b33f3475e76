// What bounces that are not followed would add, if as much of each entered again as of the last one: a
// geometric series. For opaque bodies opaque.comp adds it. One work group.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_PEAKS 6
#include "lib/group_sum.glsl"
#include "lib/linear.glsl"
#include "lib/over_or_0.glsl"
#include "lib/peaks.glsl"
#include "lib/pi.glsl"
#include "shared/boundary.h"
#include "shared/paint.h"

layout(constant_id = 0) const uint ofLast = 1u;  // 0: of the one before
layout(constant_id = 1) const uint withPaint = 0u;

layout(std430, set = 0, binding = 0) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 1) readonly buffer Latest { vec4 latest[]; };
layout(std430, set = 0, binding = 2) readonly buffer Entered { vec4 entered[]; };
// After the last bounce, what is still to come of its light, over it.
layout(std430, set = 0, binding = 3) buffer PowerBefore { vec4 powerBefore; };
layout(std430, set = 0, binding = 4) buffer Exitances { vec4 exitances[]; };
layout(std430, set = 0, binding = 5) buffer BareLights { BareLight bareLights[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
};

// Nothing enters an open body.
float areaOf(Cluster cluster) {
  return cluster.second.w > 0.0 ? pi * cluster.normal.w * cluster.normal.w : 0.0;
}

// Each bounce loses what gets out of the scene.
const float mostKept = 0.9;

void main() {
  vec3 sum = vec3(0.0);
  for (uint i = gl_LocalInvocationIndex; i < clusterCount; i += gl_WorkGroupSize.x)
    sum += areaOf(clusters[i]) * entered[i].rgb * entered[i].rgb;
  vec3 power = groupSum(sum);
  if (ofLast == 0u) {
    if (gl_LocalInvocationIndex == 0u) powerBefore = vec4(power, 0.0);
    return;
  }
  vec3 kept = min(sqrt(overOr0(power, powerBefore.rgb)), vec3(mostKept));
  vec3 series = kept / (1.0 - kept);
  memoryBarrierBuffer();
  barrier();
  if (gl_LocalInvocationIndex == 0u) powerBefore = vec4(series, 0.0);
  vec3 most = mostEntered(peakOfAll);
  for (uint i = gl_LocalInvocationIndex; i < clusterCount; i += gl_WorkGroupSize.x) {
    if (clusters[i].centroidArea.w == 0.0) continue;
    vec3 before = exitances[i].rgb;
    vec3 after = min(before + latest[i].rgb * series, max(most, before));
    exitances[i].rgb = after;
    if (withPaint == 0u) continue;
    vec3 more = mix(vec3(1.0), overOr0(after, before), greaterThan(before, vec3(0.0)));
    bareLights[i].exitance.rgb *= more;
    bareLights[i].entered.rgb *= more;
  }
}
