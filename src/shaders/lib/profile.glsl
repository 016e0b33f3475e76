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

// 1 - e^{-x} to relative float accuracy, x ≥ 0, given e^{-x}: the Taylor series where the subtraction would cancel.
vec3 oneMinusExp(vec3 x, vec3 expMinusX) {
  vec3 series =
      x * (1.0f -
           x * (1.0f / 2.0f -
                x * (1.0f / 6.0f -
                     x * (1.0f / 24.0f -
                          x * (1.0f / 120.0f - x * (1.0f / 720.0f - x * (1.0f / 5040.0f)))))));
  return mix(1.0f - expMinusX, series, lessThan(x, vec3(0.5f)));
}

// The two sources of a dipole, seen from a radius.
struct Dipole {
  vec3 overReal;  // one over the distance d_r
  vec3 overVirtual;
  vec3 further;    // Δ = d_v - d_r
  vec3 decayReal;  // e^{-σ d_r}
  vec3 decayFurther;
};

Dipole dipoleAt(Profile p, vec3 radiusSquaredMm2) {
  vec3 realSquared = radiusSquaredMm2 + p.zRealSquared;
  vec3 virtualSquared = radiusSquaredMm2 + p.zVirtualSquared;
  vec3 overReal = inversesqrt(realSquared);
  vec3 overVirtual = inversesqrt(virtualSquared);
  vec3 real = realSquared * overReal;
  vec3 further = p.zSquaredDifference / (virtualSquared * overVirtual + real);
  Dipole dipole = {overReal, overVirtual, further, exp2(-p.sigmaTrBase2 * real),
                   exp2(-p.sigmaTrBase2 * further)};
  return dipole;
}

// d'Eon 2012: α' (C_φ φ + C_E J). All terms are positive:
// e^{-σ d_r}/d_r - e^{-σ d_v}/d_v = e^{-σ d_r} (Δ/d_r + 1 - e^{-σ Δ}) / d_v.
vec3 betterDipoleProfile(Profile p, vec3 radiusSquaredMm2) {
  Dipole d = dipoleAt(p, radiusSquaredMm2);
  vec3 fluence = p.weightFluence * d.overVirtual *
                 (d.further * d.overReal + oneMinusExp(p.sigmaTr * d.further, d.decayFurther));
  vec3 fluxReal = p.weightReal * (d.overReal * d.overReal) * (d.overReal + p.sigmaTr);
  vec3 fluxVirtual = p.weightVirtual * (d.overVirtual * d.overVirtual) *
                     (d.overVirtual + p.sigmaTr) * d.decayFurther;
  return d.decayReal * (fluence + fluxReal + fluxVirtual);
}

// The integral of either profile over the plane outside a disc.
vec3 profileOutside(Profile p, vec3 radiusSquaredMm2) {
  Dipole d = dipoleAt(p, radiusSquaredMm2);
  vec3 sigma = p.sigmaTr + 1e-12f;
  vec3 fluence = p.weightFluence * oneMinusExp(sigma * d.further, d.decayFurther) / sigma;
  vec3 flux = p.weightReal * d.overReal + p.weightVirtual * d.overVirtual * d.decayFurther;
  return 6.2831853f * d.decayReal * (fluence + flux);
}

vec3 dipoleProfile(Profile p, float radiusSquaredMm2) {
  return dipoleProfile(p, vec3(radiusSquaredMm2));
}

vec3 betterDipoleProfile(Profile p, float radiusSquaredMm2) {
  return betterDipoleProfile(p, vec3(radiusSquaredMm2));
}

#endif
