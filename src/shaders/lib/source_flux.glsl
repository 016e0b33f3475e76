// What enters through a source of the surface.
#ifndef OPALINE_LIB_SOURCE_FLUX
#define OPALINE_LIB_SOURCE_FLUX

// Less flux counts as none, because sums of it would not be normal numbers.
const float leastFlux = 1e-30;

vec3 fluxThrough(float areaMm2, vec3 irradiance) {
  vec3 flux = areaMm2 * irradiance;
  return mix(vec3(0.0), flux, greaterThan(flux, vec3(leastFlux)));
}

#endif
