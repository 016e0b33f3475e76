// Directions of vectors that may be zero.
#ifndef OPALINE_LIB_UNIT
#define OPALINE_LIB_UNIT

vec3 unitOr(vec3 v, vec3 otherwise) {
  float squared = dot(v, v);
  return squared > 1e-30 && squared < 1e30 ? v * inversesqrt(squared) : otherwise;
}

#endif
