// A step of generalised minimal residuals (Saad and Schultz 1986), each channel by itself: makes the
// product orthogonal to the basis (Gram and Schmidt), which gives the next vector, and finds the
// residual by Givens rotations. Step 0 makes the first vector from the residual.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/linear.glsl"
#include "lib/group_sum.glsl"
#include "lib/over_or_0.glsl"
#include "lib/solver.glsl"
#include "shared/boundary.h"

layout(std430, set = 0, binding = 0) readonly buffer Products { vec4 products[]; };
layout(std430, set = 0, binding = 1) buffer Basis { vec4 basis[]; };
layout(std430, set = 0, binding = 2) readonly buffer Sums { vec4 sums[]; };
layout(std430, set = 0, binding = 3) buffer States { SolverState states[]; };

layout(push_constant) uniform Push {
  uint clusterCount;
  uint step;
  float tolerance;  // of the residual, relative to the right-hand side
  uint solution;
};

// What is left of a vector, relative to what it was and squared, when rounding may have made it: some
// roundings of sums of single precision.
const float leastLeft2 = 1.0 / float(1u << 21u);

vec3 total(uint k) {
  uint groups = (clusterCount + 63u) / 64u;
  vec3 sum = vec3(0.0);
  for (uint g = gl_LocalInvocationIndex; g < groups; g += 64u)
    sum += sums[g * (maxSolverSteps + 1u) + k].rgb;
  return groupSum(sum);
}

void setDone(bool done) {
  states[solution].done[doneBefore(step + 1u)] = done ? 1u : 0u;
}

void start(uint i) {
  vec3 norm = sqrt(total(0u));
  vec3 right = sqrt(total(1u));
  if (i < clusterCount) basis[i] = vec4(overOr0(products[i].rgb, norm), 0.0);
  if (i != 0u) return;
  states[solution].wanted = vec4(tolerance * right, 0.0);
  states[solution].rotated[0] = vec4(norm, 0.0);
  states[solution].residual = vec4(overOr0(norm * tolerance, states[solution].wanted.rgb), 0.0);
  states[solution].steps = 0u;
  setDone(all(lessThanEqual(norm, states[solution].wanted.rgb)));
}

// The column of the Hessenberg matrix under all rotations, and the one it adds. Where nothing but
// rounding is left of the vector, no larger than `hidden`, there is no next one, and that is as much as
// is known of the residual.
void rotate(vec3 column[maxSolverSteps + 1u], vec3 hidden) {
  uint last = step - 1u;
  for (uint k = 0u; k < last; ++k) {
    vec3 c = states[solution].cosine[k].rgb;
    vec3 s = states[solution].sine[k].rgb;
    vec3 upper = c * column[k] + s * column[k + 1u];
    column[k + 1u] = c * column[k + 1u] - s * column[k];
    column[k] = upper;
  }
  vec3 size = sqrt(column[last] * column[last] + column[step] * column[step]);
  vec3 c = overOr0(column[last], size);
  vec3 s = overOr0(column[step], size);
  column[last] = size;
  for (uint k = 0u; k <= last; ++k)
    states[solution].hessenberg[last * (maxSolverSteps + 1u) + k] = vec4(column[k], 0.0);
  vec3 before = states[solution].rotated[last].rgb;
  states[solution].cosine[last] = vec4(c, 0.0);
  states[solution].sine[last] = vec4(s, 0.0);
  states[solution].rotated[last] = vec4(c * before, 0.0);
  vec3 part = mix(min(max(s, overOr0(hidden, size)), 1.0), vec3(1.0), lessThanEqual(size, vec3(0.0)));
  states[solution].rotated[step] = vec4(-part * before, 0.0);
  vec3 left = abs(part * before);
  states[solution].residual = vec4(overOr0(left * tolerance, states[solution].wanted.rgb), 0.0);
  states[solution].steps = step;
  vec3 toGo = mix(left, vec3(0.0), lessThanEqual(column[step], vec3(0.0)));
  setDone(all(lessThanEqual(toGo, states[solution].wanted.rgb)));
}

void main() {
  uint i = linearIndex();
  if (step == 0u) {
    start(i);
    return;
  }
  if (states[solution].done[doneBefore(step)] != 0u) {
    if (i == 0u) setDone(true);
    return;
  }
  bool inside = i < clusterCount;
  vec3 vector = inside ? products[i].rgb : vec3(0.0);
  vec3 column[maxSolverSteps + 1u];
  vec3 left2 = total(step);
  vec3 all2 = left2;
  for (uint k = 0u; k < step; ++k) {
    column[k] = total(k);
    left2 -= column[k] * column[k];
    if (inside) vector -= column[k] * basis[k * clusterCount + i].rgb;
  }
  bvec3 rounded = lessThanEqual(left2, leastLeft2 * all2);
  column[step] = mix(sqrt(max(left2, 0.0)), vec3(0.0), rounded);
  if (inside) basis[step * clusterCount + i] = vec4(overOr0(vector, column[step]), 0.0);
  if (i == 0u) rotate(column, mix(vec3(0.0), sqrt(leastLeft2 * all2), rounded));
}
