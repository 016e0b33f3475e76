// Adds the combination of the basis that leaves the smallest residual to the fluence.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "lib/over_or_0.glsl"
#include "shared/boundary.h"

layout(std430, set = 0, binding = 0) buffer Fluences { vec4 fluences[]; };
layout(std430, set = 0, binding = 1) readonly buffer Basis { vec4 basis[]; };
layout(std430, set = 0, binding = 2) readonly buffer States { SolverState states[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint solution;
};

void main() {
  uint i = linearIndex();
  if (i >= clusterCount) return;
  vec3 weights[maxSolverSteps];
  vec3 sum = vec3(0.0);
  for (uint k = states[solution].steps; k-- > 0u;) {
    vec3 rest = states[solution].rotated[k].rgb;
    for (uint j = k + 1u; j < states[solution].steps; ++j)
      rest -= states[solution].hessenberg[j * (maxSolverSteps + 1u) + k].rgb * weights[j];
    weights[k] = overOr0(rest, states[solution].hessenberg[k * (maxSolverSteps + 1u) + k].rgb);
    sum += weights[k] * basis[k * clusterCount + i].rgb;
  }
  fluences[i].rgb += sum;
}
