// Radial profiles R_d(r) of a half-space, the GPU's version of bssrdf/profile.h. Also compiled as
// C++ with glm by the tests: no swizzles, literals with f.
#ifndef OPALINE_SHADERS_LIB_PROFILE_GLSL
#define OPALINE_SHADERS_LIB_PROFILE_GLSL

#include "../shared/profile_data.h"

// Jensen et al. 2001, Eq. 4: Σ_z w (1 + σ d) e^{-σ d} / d³, written with 1/d.
vec3 dipoleProfile(Profile p, vec3 radiusSquaredMm2) {
  vec3 realSquared = radiusSquaredMm2 + p.zRealSquared;
  vec3 virtualSquared = radiusSquaredMm2 + p.zVirtualSquared;
  vec3 overReal = inversesqrt(realSquared);
  vec3 overVirtual = inversesqrt(virtualSquared);
  vec3 decayReal = exp2(-p.sigmaTrBase2 * (realSquared * overReal));
  vec3 decayVirtual = exp2(-p.sigmaTrBase2 * (virtualSquared * overVirtual));
  return p.weightReal * decayReal * (overReal * overReal) * (overReal + p.sigmaTr) +
         p.weightVirtual * decayVirtual * (overVirtual * overVirtual) * (overVirtual + p.sigmaTr);
}

// 1 - e^{-x} to float accuracy relative to itself, x ≥ 0, with e^{-x} given: the Taylor series
// where the subtraction would cancel.
vec3 oneMinusExp(vec3 x, vec3 expMinusX) {
  vec3 series =
      x * (1.0f -
           x * (1.0f / 2.0f -
                x * (1.0f / 6.0f -
                     x * (1.0f / 24.0f -
                          x * (1.0f / 120.0f - x * (1.0f / 720.0f - x * (1.0f / 5040.0f)))))));
  return mix(1.0f - expMinusX, series, lessThan(x, vec3(0.5f)));
}

// d'Eon 2012: α' (C_φ φ + C_E J). With Δ = d_v - d_r, all terms positive:
// e^{-σ d_r}/d_r - e^{-σ d_v}/d_v = e^{-σ d_r} (Δ/d_r + 1 - e^{-σ Δ}) / d_v.
vec3 betterDipoleProfile(Profile p, vec3 radiusSquaredMm2) {
  vec3 realSquared = radiusSquaredMm2 + p.zRealSquared;
  vec3 virtualSquared = radiusSquaredMm2 + p.zVirtualSquared;
  vec3 overReal = inversesqrt(realSquared);
  vec3 overVirtual = inversesqrt(virtualSquared);
  vec3 real = realSquared * overReal;
  vec3 further = p.zSquaredDifference / (virtualSquared * overVirtual + real);
  vec3 decayReal = exp2(-p.sigmaTrBase2 * real);
  vec3 decayFurther = exp2(-p.sigmaTrBase2 * further);
  vec3 fluence = p.weightFluence * overVirtual *
                 (further * overReal + oneMinusExp(p.sigmaTr * further, decayFurther));
  vec3 fluxReal = p.weightReal * (overReal * overReal) * (overReal + p.sigmaTr);
  vec3 fluxVirtual =
      p.weightVirtual * (overVirtual * overVirtual) * (overVirtual + p.sigmaTr) * decayFurther;
  return decayReal * (fluence + fluxReal + fluxVirtual);
}

// The integral of either over all of the plane outside a disc.
vec3 profileOutside(Profile p, vec3 radiusSquaredMm2) {
  vec3 realSquared = radiusSquaredMm2 + p.zRealSquared;
  vec3 virtualSquared = radiusSquaredMm2 + p.zVirtualSquared;
  vec3 overReal = inversesqrt(realSquared);
  vec3 overVirtual = inversesqrt(virtualSquared);
  vec3 real = realSquared * overReal;
  vec3 further = p.zSquaredDifference / (virtualSquared * overVirtual + real);
  vec3 decayReal = exp2(-p.sigmaTrBase2 * real);
  vec3 decayFurther = exp2(-p.sigmaTrBase2 * further);
  vec3 sigma = p.sigmaTr + 1e-12f;
  vec3 fluence = p.weightFluence * oneMinusExp(sigma * further, decayFurther) / sigma;
  vec3 flux = p.weightReal * overReal + p.weightVirtual * overVirtual * decayFurther;
  return 6.2831853f * decayReal * (fluence + flux);
}

vec3 dipoleProfile(Profile p, float radiusSquaredMm2) {
  return dipoleProfile(p, vec3(radiusSquaredMm2));
}

vec3 betterDipoleProfile(Profile p, float radiusSquaredMm2) {
  return betterDipoleProfile(p, vec3(radiusSquaredMm2));
}

#endif
