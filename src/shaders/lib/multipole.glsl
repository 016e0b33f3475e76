// The profiles of lib/profile.glsl for sources that are spread out: value and derivatives by the
// square of the distance. Also compiled as C++ with glm by the tests: no swizzles, literals with f.
//
// Both profiles are sums over poles at depth z of w E_k(D), D² = s + z², s = r², x = σ D, with
//   E_0 = e^{-x} / D                          E_1 = e^{-x} (1 + x) / D³
//   E_2 = e^{-x} (3 + 3x + x²) / D⁵           E_3 = e^{-x} (15 + 15x + 6x² + x³) / D⁷
// (reverse Bessel polynomials), a chain in which dE_k/ds = -E_{k+1} / 2.
#ifndef OPALINE_SHADERS_LIB_MULTIPOLE_GLSL
#define OPALINE_SHADERS_LIB_MULTIPOLE_GLSL

#include "profile.glsl"

struct Derivatives {
  vec3 value;
  vec3 first;   // by s
  vec3 second;  // by s, twice
};

Derivatives dipoleDerivatives(Profile p, vec3 squaredMm2) {
  Derivatives sum;
  sum.value = vec3(0.0f);
  sum.first = vec3(0.0f);
  sum.second = vec3(0.0f);
  for (int pole = 0; pole < 2; ++pole) {
    vec3 squared = squaredMm2 + (pole == 0 ? p.zRealSquared : p.zVirtualSquared);
    vec3 over = inversesqrt(squared);
    vec3 over2 = over * over;
    vec3 distance = squared * over;
    vec3 x = p.sigmaTr * distance;
    vec3 e = (pole == 0 ? p.weightReal : p.weightVirtual) * exp2(-p.sigmaTrBase2 * distance) * over *
             over2;
    sum.value += e * (x + 1.0f);
    e *= over2;
    sum.first -= 0.5f * e * (x * (x + 3.0f) + 3.0f);
    sum.second += 0.25f * (e * over2) * (x * (x * (x + 6.0f) + 15.0f) + 15.0f);
  }
  return sum;
}

// d'Eon 2012 as in betterDipoleProfile: flux terms are as above, fluence is one step before them.
Derivatives betterDipoleDerivatives(Profile p, vec3 squaredMm2) {
  Derivatives sum = dipoleDerivatives(p, squaredMm2);
  sum.value = betterDipoleProfile(p, squaredMm2);
  for (int pole = 0; pole < 2; ++pole) {
    vec3 squared = squaredMm2 + (pole == 0 ? p.zRealSquared : p.zVirtualSquared);
    vec3 over = inversesqrt(squared);
    vec3 over2 = over * over;
    vec3 distance = squared * over;
    vec3 x = p.sigmaTr * distance;
    vec3 e = p.weightFluence * exp2(-p.sigmaTrBase2 * distance) * over * over2;
    if (pole == 1) e = -e;
    sum.first -= 0.5f * e * (x + 1.0f);
    sum.second += 0.25f * (e * over2) * (x * (x + 3.0f) + 3.0f);
  }
  return sum;
}

#endif
