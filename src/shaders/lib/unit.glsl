// Directions of vectors that may be zero.
#ifndef OPALINE_LIB_UNIT
#define OPALINE_LIB_UNIT

// The square of a long or short vector may not be a float, so it is scaled first.
vec3 unitOr(vec3 v, vec3 otherwise) {
  float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
  if (!(largest > 1e-30 && largest < 1e30)) return otherwise;
  vec3 scaled = v / largest;
  float squared = dot(scaled, scaled);
  return squared > 0.0 ? scaled * inversesqrt(squared) : otherwise;  // if it is a number
}

#endif
