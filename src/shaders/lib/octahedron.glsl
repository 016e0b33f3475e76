// Unit vectors in two numbers from -1 to 1 (Cigolle et al. 2014).
#ifndef OPALINE_LIB_OCTAHEDRON
#define OPALINE_LIB_OCTAHEDRON

vec2 awayFromZero(vec2 v) {
  return mix(vec2(-1.0), vec2(1.0), greaterThanEqual(v, vec2(0.0)));
}

vec2 toOctahedron(vec3 unit) {
  vec2 p = unit.xy / (abs(unit.x) + abs(unit.y) + abs(unit.z));
  return unit.z >= 0.0 ? p : (1.0 - abs(p.yx)) * awayFromZero(p);
}

vec3 fromOctahedron(vec2 p) {
  float z = 1.0 - abs(p.x) - abs(p.y);
  return normalize(vec3(z >= 0.0 ? p : (1.0 - abs(p.yx)) * awayFromZero(p), z));
}

#endif
