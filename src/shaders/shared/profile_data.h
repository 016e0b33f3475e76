// Included by C++ and GLSL.
#ifndef OPALINE_SHADERS_SHARED_PROFILE_DATA_H
#define OPALINE_SHADERS_SHARED_PROFILE_DATA_H

#ifdef __cplusplus
#include <glm/vec3.hpp>

namespace opaline::shared {

using glm::vec3;
#endif

// A radial profile of three channels with all constant factors multiplied out, std430. It serves
// both models and is filled by packProfile() of shaders/profile_packing.h. Lengths in mm.
struct Profile {
  vec3 zRealSquared;  // z_r²
  float padding0;
  vec3 zVirtualSquared;  // z_v²
  float padding1;
  vec3 zSquaredDifference;  // z_v² - z_r²
  float padding2;
  vec3 sigmaTr;  // σ_tr
  float padding3;
  vec3 sigmaTrBase2;  // σ_tr / ln 2, so that e^{-σ_tr d} = 2^{-this · d}
  float padding4;
  vec3 weightReal;  // z_r α'/4π, for BetterDipole times C_E
  float padding5;
  vec3 weightVirtual;  // z_v α'/4π, for BetterDipole times C_E
  float padding6;
  vec3 weightFluence;  // α' C_φ / 4πD, for Dipole 0
  float padding7;
};

#ifdef __cplusplus

}  // namespace opaline::shared
#endif

#endif
