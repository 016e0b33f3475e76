// The end of a step of generalised minimal residuals (Saad and Schultz 1986), each channel by itself: from
// the inner products what makes the last product orthogonal to the basis (Gram and Schmidt), and the
// residual by Givens rotations. One work group.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/group_sum.glsl"
#include "lib/linear.glsl"
#include "lib/over_or_0.glsl"
#include "shared/boundary.h"

layout(std430, set = 0, binding = 0) readonly buffer Sums { vec4 sums[]; };  // of tiles
layout(std430, set = 0, binding = 1) buffer States { SolverState states[]; };

layout(push_constant) uniform Push {
  uint tileCount;
  float tolerance;  // of the residual, relative to the sources and to what entered at the surface
  uint step;        // skipped when the solver is done
  uint solution;
};

// What is left of a vector, relative to what it was and squared, when rounding may have made it: some
// roundings of sums of single precision.
const float leastLeft2 = 1.0 / float(1u << 21u);

vec3 total(uint k) {
  vec3 sum = vec3(0.0);
  for (uint t = gl_LocalInvocationIndex; t < tileCount; t += gl_WorkGroupSize.x)
    sum += sums[t * (maxSolverSteps + 1u) + k].rgb;
  return groupSum(sum);
}

void setDone(vec3 toGo) {
  states[solution].done = all(lessThanEqual(toGo, states[solution].wanted.rgb)) ? 1u : 0u;
}

void start(vec3 norm, vec3 scale) {
  states[solution].wanted = vec4(tolerance * scale, 0.0);
  states[solution].rotated[0] = vec4(norm, 0.0);
  states[solution].residual = vec4(overOr0(norm, scale), 0.0);
  states[solution].steps = 0u;
  setDone(norm);
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
  setDone(toGo);
}

void main() {
  if (step > 0u && states[solution].done != 0u) return;
  vec3 column[maxSolverSteps + 1u];
  vec3 left2 = total(step);
  vec3 entered = step == 0u ? sqrt(total(1u)) : vec3(0.0);
  vec3 all2 = left2;
  for (uint k = 0u; k < step; ++k) {
    column[k] = total(k);
    left2 -= column[k] * column[k];
  }
  bvec3 rounded = step == 0u ? bvec3(false) : lessThanEqual(left2, leastLeft2 * all2);
  column[step] = mix(sqrt(max(left2, 0.0)), vec3(0.0), rounded);
  if (gl_LocalInvocationIndex != 0u) return;
  for (uint k = 0u; k <= step; ++k) states[solution].projections[k] = vec4(column[k], 0.0);
  if (step == 0u)
    start(column[0], column[0] + entered);
  else
    rotate(column, mix(vec3(0.0), sqrt(leastLeft2 * all2), rounded));
}
