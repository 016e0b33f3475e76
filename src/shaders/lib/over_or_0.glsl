// Quotients that are 0 where the divisor is.
#ifndef OPALINE_LIB_OVER_OR_0
#define OPALINE_LIB_OVER_OR_0

vec3 overOr0(vec3 a, vec3 b) {
  return mix(a / b, vec3(0.0), lessThanEqual(abs(b), vec3(1e-30)));
}

#endif
