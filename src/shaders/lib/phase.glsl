// How single collisions scatter: Henyey and Greenstein 1941, with the mean cosine g.
#ifndef OPALINE_LIB_PHASE
#define OPALINE_LIB_PHASE

// The phase function over that of even scattering, 1/4π.
float phaseOverEven(float cosine, float g) {
  float squared = max(1.0 + g * g - 2.0 * g * cosine, 1e-6);
  return (1.0 - g * g) * inversesqrt(squared) / squared;
}

// The cosine above which that part of scattered light goes on; g is not 0.
float cosineOfPart(float part, float g) {
  float root = (1.0 - g * g) / (1.0 + g - 2.0 * g * part);
  return clamp((1.0 + g * g - root * root) / (2.0 * g), -1.0, 1.0);
}

#endif
