// A lattice of low discrepancy over the unit square (Roberts 2018).
#ifndef OPALINE_LIB_LATTICE
#define OPALINE_LIB_LATTICE

vec2 latticePlace(uint i) {
  return fract(float(i) * vec2(0.7548776662, 0.5698402910));
}

#endif
