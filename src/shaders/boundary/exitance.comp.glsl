// What leaves through every cluster: M = M₁ + α'φ / 2A, added to that of light which entered before.
#version 460
#extension GL_GOOGLE_include_directive : require
#define BINDING_OBJECTS 0
#define BINDING_MEDIA 1
#include "lib/boundary.glsl"
#include "lib/linear.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Ranges { ClusterRange ranges[]; };
layout(std430, set = 0, binding = 3) readonly buffer Fluences { vec4 fluences[]; };
layout(std430, set = 0, binding = 4) buffer Latest { vec4 latest[]; };  // M₁, then M of this light
layout(std430, set = 0, binding = 5) buffer Exitances { vec4 exitances[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint adds;  // 1: to what entered before
};

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  BoundaryMedium medium = insideOf(objects[ranges[i].object]);
  vec3 leaves = latest[i].rgb + medium.albedo.rgb * fluences[i].rgb / (2.0 * medium.diffusion.w);
  leaves = max(leaves, vec3(0.0));
  latest[i] = vec4(leaves, 0.0);
  exitances[i] = vec4(adds != 0u ? exitances[i].rgb + leaves : leaves, 0.0);
}
