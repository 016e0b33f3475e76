// Sums over a work group of 64, the same on every device.
#ifndef OPALINE_LIB_GROUP_SUM
#define OPALINE_LIB_GROUP_SUM

shared vec3 groupTerms[64];

// Every invocation of the group calls it, and each gets the sum.
vec3 groupSum(vec3 term) {
  uint i = gl_LocalInvocationIndex;
  groupTerms[i] = term;
  barrier();
  for (uint width = 32u; width > 0u; width /= 2u) {
    if (i < width) groupTerms[i] += groupTerms[i + width];
    barrier();
  }
  vec3 sum = groupTerms[0];
  barrier();
  return sum;
}

#endif
