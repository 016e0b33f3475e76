// Sums over sources that lie further apart than the profile is wide. Included by C++ and GLSL.
//
// Within a reach R of so many spacings the sum takes a smoother profile f(s̃), s̃ ≥ s = r², that
// the sources can follow. What it lacks, f(s) - f(s̃), is integrated beforehand over a disc and two
// rings around it, and multiplied by the irradiance found there (singularity subtraction).
#ifndef OPALINE_SHARED_NEARBY_H
#define OPALINE_SHARED_NEARBY_H

#ifdef __cplusplus
#include <algorithm>
namespace opaline::shared {
#define OPALINE_NEARBY_NUMBER constexpr float
#define OPALINE_NEARBY_INLINE inline
#else
#define OPALINE_NEARBY_NUMBER const float
#define OPALINE_NEARBY_INLINE
#endif

/// The reach, in spacings of the sources. With 3 spacings, sums over threes of sources
/// (surfels.comp) are off by 0.7 % beside their corners; with 4, by no more than 0.15 %.
OPALINE_NEARBY_NUMBER reachInSpacings = 4.0f;

/// Borders of the disc and the rings, and where the irradiance of the rings is found, in reaches.
OPALINE_NEARBY_NUMBER discInReaches = 0.125f;
OPALINE_NEARBY_NUMBER innerRingInReaches = 0.375f;
OPALINE_NEARBY_NUMBER innerRingAt = 0.23f;
OPALINE_NEARBY_NUMBER outerRingAt = 0.55f;

/// s̃: s + (R² - s)³ / 3R⁴ within the reach, s beyond it; twice differentiable.
OPALINE_NEARBY_INLINE float smoothedSquare(float squaredMm2, float squaredReachMm2) {
#ifdef __cplusplus
  using std::max;
#endif
  float left = max(1.0f - squaredMm2 / squaredReachMm2, 0.0f);
  return squaredMm2 + squaredReachMm2 / 3.0f * left * left * left;
}

/// The weight of a place around, which falls to 0 at the reach, so that sums by it do not jump
/// where a place crosses the border. Its integral over the plane is πR²/3.
OPALINE_NEARBY_INLINE float nearbyWeight(float squaredMm2, float squaredReachMm2) {
  float left = 1.0f - squaredMm2 / squaredReachMm2;
  return left * left;
}

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif
