// The end of a step of generalised minimal residuals (Saad and Schultz 1986), each channel by itself. Inner
// products make the last product orthogonal to the basis (Gram and Schmidt), and Givens rotations give the
// residual. A part of boundary/product.comp.glsl, which has `states`, `sums` of tiles, and the push constants.
#ifndef OPALINE_LIB_SOLVER_STEP
#define OPALINE_LIB_SOLVER_STEP
#include "lib/over_or_0.glsl"

// Below this, what is left of a vector, relative to what it was and squared, may come from rounding:
// some roundings of sums of single precision.
const float leastLeft2 = 1.0 / float(1u << 21u);

// Inner products over the tiles that each subgroup has.
shared vec3 totals[maxSolverSteps + 1u][invocationsOfTile / 4u];  // for subgroups of at least 4
// The rotations so far.
shared vec3 cosines[maxSolverSteps];
shared vec3 sines[maxSolverSteps];

// Every invocation of the group calls it.
void putTotals() {
  uint last = max(step, 1u);
  for (uint k = 0u; k <= last; ++k) {
    vec3 sum = vec3(0.0);
    for (uint t = gl_LocalInvocationIndex; t < tileCount; t += invocationsOfTile)
      sum += sums[t * (maxSolverSteps + 1u) + k].rgb;
    sum = subgroupAdd(sum);
    if (subgroupElect()) totals[k][gl_SubgroupID] = sum;
  }
  for (uint k = gl_LocalInvocationIndex; k + 1u < step; k += invocationsOfTile) {
    cosines[k] = states[solution].cosine[k].rgb;
    sines[k] = states[solution].sine[k].rgb;
  }
  barrier();
}

vec3 total(uint k) {
  vec3 sum = vec3(0.0);
  for (uint g = 0u; g < gl_NumSubgroups; ++g) sum += totals[k][g];
  return sum;
}

void orderNextStep(vec3 toGo) {
  bool done = all(lessThanEqual(toGo, states[solution].wanted.rgb));
  states[solution].groupsOfDensities = done ? uvec4(0u) : uvec4(densityGroups, 1u, 1u, 0u);
  states[solution].groupsOfProduct = done ? uvec4(0u) : uvec4(tileCount, 1u, 1u, 0u);
}

void start(vec3 norm, vec3 scale) {
  states[solution].wanted = vec4(tolerance * scale, 0.0);
  states[solution].rotated[0] = vec4(norm, 0.0);
  states[solution].residual = vec4(overOr0(norm, scale), 0.0);
  states[solution].steps = 0u;
  orderNextStep(norm);
}

// Writes the column of the Hessenberg matrix, which is the projections under all rotations, and adds its
// own rotation. Where rounding alone is left of the vector, no more than `hidden`, there is no next one,
// and no more is known of the residual.
void rotate(vec3 left, vec3 hidden) {
  uint last = step - 1u;
  uint column = last * (maxSolverSteps + 1u);
  vec3 lower = total(0u);
  for (uint k = 0u; k < last; ++k) {
    vec3 c = cosines[k];
    vec3 s = sines[k];
    vec3 next = total(k + 1u);
    states[solution].hessenberg[column + k] = vec4(c * lower + s * next, 0.0);
    lower = c * next - s * lower;
  }
  vec3 size = sqrt(lower * lower + left * left);
  vec3 c = overOr0(lower, size);
  vec3 s = overOr0(left, size);
  states[solution].hessenberg[column + last] = vec4(size, 0.0);
  vec3 before = states[solution].rotated[last].rgb;
  states[solution].cosine[last] = vec4(c, 0.0);
  states[solution].sine[last] = vec4(s, 0.0);
  states[solution].rotated[last] = vec4(c * before, 0.0);
  vec3 part = mix(min(max(s, overOr0(hidden, size)), 1.0), vec3(1.0), lessThanEqual(size, vec3(0.0)));
  states[solution].rotated[step] = vec4(-part * before, 0.0);
  vec3 residual = abs(part * before);
  states[solution].residual = vec4(overOr0(residual * tolerance, states[solution].wanted.rgb), 0.0);
  states[solution].steps = step;
  orderNextStep(mix(residual, vec3(0.0), lessThanEqual(left, vec3(0.0))));
}

// One invocation calls it after putTotals().
void endStep() {
  vec3 all2 = total(step);
  vec3 entered = step == 0u ? sqrt(total(1u)) : vec3(0.0);
  vec3 left2 = all2;
  for (uint k = 0u; k < step; ++k) {
    vec3 projection = total(k);
    left2 -= projection * projection;
    states[solution].projections[k] = vec4(projection, 0.0);
  }
  states[solution].tilesDone = 0u;
  bvec3 rounded = step == 0u ? bvec3(false) : lessThanEqual(left2, leastLeft2 * all2);
  vec3 left = mix(sqrt(max(left2, 0.0)), vec3(0.0), rounded);
  states[solution].projections[step] = vec4(left, 0.0);
  if (step == 0u)
    start(left, left + entered);
  else
    rotate(left, mix(vec3(0.0), sqrt(leastLeft2 * all2), rounded));
}

#endif
