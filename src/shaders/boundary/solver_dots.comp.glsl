// Inner products, weighted by area, that a step of the solver needs: of the product with each vector
// of the basis so far, then with itself. One sum a work group. At the start, step 0, of the residual
// and of the right-hand side with themselves.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "lib/group_sum.glsl"
#include "lib/solver.glsl"
#include "shared/boundary.h"

layout(std430, set = 0, binding = 0) readonly buffer Clusters { Cluster clusters[]; };
layout(std430, set = 0, binding = 1) readonly buffer Products { vec4 products[]; };
layout(std430, set = 0, binding = 2) readonly buffer Basis { vec4 basis[]; };
layout(std430, set = 0, binding = 3) readonly buffer Wanted { vec4 wanted[]; };
layout(std430, set = 0, binding = 4) writeonly buffer Sums { vec4 sums[]; };
layout(std430, set = 0, binding = 5) readonly buffer States { SolverState states[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint step;
  uint solution;
};

void main() {
  if (step > 0u && states[solution].done[doneBefore(step)] != 0u) return;
  uint i = linearIndex();
  bool inside = i < clusterCount;
  uint group = i / 64u;
  vec3 product = inside ? products[i].rgb : vec3(0.0);
  vec3 weighted = inside ? clusters[i].centroidArea.w * product : vec3(0.0);
  uint first = group * (maxSolverSteps + 1u);
  if (step == 0u) {
    vec3 right = inside ? wanted[i].rgb : vec3(0.0);
    vec3 itself = groupSum(weighted * product);
    vec3 rights = groupSum(inside ? clusters[i].centroidArea.w * right * right : vec3(0.0));
    if (gl_LocalInvocationIndex == 0u) {
      sums[first] = vec4(itself, 0.0);
      sums[first + 1u] = vec4(rights, 0.0);
    }
    return;
  }
  for (uint k = 0u; k <= step; ++k) {
    vec3 other = !inside ? vec3(0.0) : k < step ? basis[k * clusterCount + i].rgb : product;
    vec3 sum = groupSum(weighted * other);
    if (gl_LocalInvocationIndex == 0u) sums[first + k] = vec4(sum, 0.0);
  }
}
