// Two axes at right angles to a direction.
#ifndef OPALINE_LIB_AXES
#define OPALINE_LIB_AXES

// Unit vectors that form a right-handed frame with a unit direction (Duff et al. 2017).
mat2x3 axesAcross(vec3 direction) {
  float s = direction.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (s + direction.z);
  float b = direction.x * direction.y * a;
  return mat2x3(vec3(1.0 + s * direction.x * direction.x * a, s * b, -s * direction.x),
                vec3(b, s + direction.y * direction.y * a, -direction.y));
}

#endif
